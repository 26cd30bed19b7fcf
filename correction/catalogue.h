#pragma once

#include <span>
#include <string_view>

#include "correction/effect_kind.h"

namespace raceway::correction {

/// Returns the effects on a displacement over time, sorted by id: see
/// correction/effects/all_effects.h.
[[nodiscard]] std::span<const EffectKind* const> kinds();
/// Returns the effect with this id; null if there is none.
[[nodiscard]] const EffectKind* find_kind(std::string_view id);

/// Returns the descriptions of the effects, sorted by id.
[[nodiscard]] std::span<const EffectCard> catalogue();
[[nodiscard]] const EffectCard* find_card(std::string_view id);

}  // namespace raceway::correction
