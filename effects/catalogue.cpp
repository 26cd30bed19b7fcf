#include "effects/catalogue.h"

#include <array>
#include <tuple>

#include "effects/formula.h"

namespace raceway::effects {
namespace {

/// An effect takes the steps that its struct has.
template <typename E>
constexpr Description describe() {
  Description d{.id = E::id,
                .title = E::title,
                .mechanism = E::mechanism,
                .formula = E::formula,
                .source = E::source,
                .confused_with = E::confused_with,
                .parameters = E::parameters,
                .needs = E::needs};
  if constexpr (requires { E::needs_equilibrium; }) d.needs_equilibrium = E::needs_equilibrium;
  if constexpr (requires { E::grows_with_the_rotor; })
    d.grows_with_the_rotor = E::grows_with_the_rotor;
  if constexpr (requires { &E::condition; }) d.condition = &E::condition;
  if constexpr (requires { &E::lubricant; }) d.lubricant = &E::lubricant;
  if constexpr (requires { &E::moment; }) d.moment = &E::moment;
  if constexpr (requires { &E::unit_moment; }) {
    static_assert(E::parameters.size() == 1, "unit_moment belongs to one linear parameter");
    d.unit_moment = &E::unit_moment;
  }
  if constexpr (requires { &E::reading; }) d.reading = &E::reading;
  return d;
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

std::string_view text(Need need) {
  switch (need) {
    case Need::speed_levels:
      return "more than one speed";
    case Need::load_levels:
      return "more than one load";
    case Need::viscosity_levels:
      return "more than one temperature";
    case Need::time:
      return "time_s of every row";
    case Need::ring_temperatures:
      return "inner_ring_temperature_C and outer_ring_temperature_C of every row";
    case Need::loads:
      return "a load on every row, to solve for the balls";
    case Need::ball_load_law:
      return "an effect in the model that uses ball loads, as spin-friction does: the base law "
             "sees the entered load only";
    case Need::palmgren_law:
      return "the palmgren law: the skf law contains this effect";
    case Need::torque_standard:
      return "a known torque to compare with: torque alone cannot tell it from a common factor on "
             "all moments";
  }
  return "";
}

std::string_view Description::step() const {
  if (condition) return "condition";
  if (lubricant) return "lubricant";
  return has_moment() ? "moment" : "reading";
}

double Effect::moment(const MomentInputs& inputs) const {
  const Description& d = *description;
  if (d.unit_moment) return values[0] * d.unit_moment(inputs);
  if (d.moment) return d.moment(inputs, values);
  return d.user_made ? d.user_made->moment(inputs, values) : 0.0;
}

std::vector<double> initial_values(const Description& description) {
  std::vector<double> values;
  for (const Parameter& p : description.parameters) values.push_back(p.initial);
  return values;
}

std::vector<double> neutral_values(const Description& description) {
  std::vector<double> values;
  for (const Parameter& p : description.parameters)
    values.push_back(p.neutral == p.neutral ? p.neutral : p.initial);
  return values;
}

}  // namespace raceway::effects
