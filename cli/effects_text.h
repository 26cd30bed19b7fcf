#pragma once

#include <span>

#include "correction/catalogue.h"
#include "effects/effect.h"

/// The catalogue of effects as text for a terminal.
namespace raceway::cli {

/// Prints one line for each effect, even if `list` has separate entries for rig, shaft and spindle.
void print_effect_list(std::span<const effects::Description> list);
/// Prints one line for each effect on a displacement over time.
void print_effect_list(std::span<const correction::EffectCard> cards);

/// Prints all catalogue data of one effect.
void print_effect_card(const effects::Description& effect);
void print_effect_card(const correction::EffectCard& card);

}  // namespace raceway::cli
