#include "effects/catalogue.h"

#include <array>
#include <tuple>

namespace raceway::effects {
namespace {

template <typename E>
constexpr Description describe() {
  return {.id = E::id,
          .title = E::title,
          .mechanism = E::mechanism,
          .formula = E::formula,
          .source = E::source,
          .confused_with = E::confused_with,
          .parameters = E::parameters,
          .needs_equilibrium = E::needs_equilibrium,
          .moment = &E::template moment<double>};
}

template <typename... E>
constexpr std::array<Description, sizeof...(E)> describe_all(const std::tuple<E...>*) {
  return {describe<E>()...};
}

constexpr auto descriptions = describe_all(static_cast<const Catalogue*>(nullptr));

}  // namespace

std::span<const Description> catalogue() { return descriptions; }

const Description* find(std::string_view id) {
  for (const Description& d : descriptions)
    if (d.id == id) return &d;
  return nullptr;
}

}  // namespace raceway::effects
