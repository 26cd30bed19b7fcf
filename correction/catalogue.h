#pragma once

#include <span>
#include <string_view>

#include "correction/effect_kind.h"

namespace raceway::correction {

/// Returns all effects of the catalogue for a displacement over time, sorted by id: see
/// correction/effects/all_effects.h.
[[nodiscard]] std::span<const EffectKind* const> kinds();
/// Returns the effect of the catalogue with this id; null if there is none.
[[nodiscard]] const EffectKind* find_kind(std::string_view id);

/// Returns the descriptions of all effects of the catalogue, sorted by id.
[[nodiscard]] std::span<const EffectCard> catalogue();
[[nodiscard]] const EffectCard* find_card(std::string_view id);

}  // namespace raceway::correction
