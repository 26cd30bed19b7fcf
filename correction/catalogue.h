#pragma once

#include <span>
#include <string_view>

#include "correction/effect_kind.h"

namespace raceway::correction {

/// Effects on a displacement over time, by id: see correction/effects/all_effects.h.
[[nodiscard]] std::span<const EffectKind* const> kinds();
/// Null where there is none of that id.
[[nodiscard]] const EffectKind* find_kind(std::string_view id);

/// Their cards.
[[nodiscard]] std::span<const EffectCard> catalogue();
[[nodiscard]] const EffectCard* find_card(std::string_view id);

}  // namespace raceway::correction
