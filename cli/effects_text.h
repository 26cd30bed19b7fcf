#pragma once

#include <span>

#include "correction/catalogue.h"
#include "effects/effect.h"

/// Prints the catalogue of effects on a terminal.
namespace raceway::cli {

/// Prints one line for each effect id. An effect may have several entries with the same id in
/// `list`, one for each kind of model. These entries must be neighbours.
void print_effect_list(std::span<const effects::Description> list);
/// Prints one line for each effect of the catalogue for corrections.
void print_effect_list(std::span<const correction::EffectCard> cards);

/// Prints all catalogue data of one effect.
void print_effect_card(const effects::Description& effect);
void print_effect_card(const correction::EffectCard& card);

}  // namespace raceway::cli
