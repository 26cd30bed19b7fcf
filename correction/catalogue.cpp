#include "correction/catalogue.h"

#include <array>
#include <tuple>

#include "correction/effects/all_effects.h"

namespace raceway::correction {
namespace {

constexpr std::size_t number_of_effects = std::tuple_size_v<AllEffects>;

}  // namespace

std::span<const EffectKind* const> kinds() {
  static const AllEffects all{};
  static const std::array<const EffectKind*, number_of_effects> list = std::apply(
      [](const auto&... kind) {
        return std::array<const EffectKind*, number_of_effects>{&kind...};
      },
      all);
  return list;
}

const EffectKind* find_kind(std::string_view id) {
  for (const EffectKind* kind : kinds())
    if (kind->card().id == id) return kind;
  return nullptr;
}

std::span<const EffectCard> catalogue() {
  static const auto cards = [] {
    std::array<EffectCard, number_of_effects> list{};
    for (std::size_t k = 0; k < number_of_effects; ++k) list[k] = kinds()[k]->card();
    return list;
  }();
  return cards;
}

const EffectCard* find_card(std::string_view id) {
  for (const EffectCard& card : catalogue())
    if (card.id == id) return &card;
  return nullptr;
}

}  // namespace raceway::correction
