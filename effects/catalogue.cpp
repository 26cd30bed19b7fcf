#include "effects/catalogue.h"

#include <array>
#include <cmath>
#include <cstddef>
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
  if constexpr (requires { E::follows_heat; }) d.follows_heat = E::follows_heat;
  if constexpr (requires { &E::condition; }) d.condition = &E::condition;
  if constexpr (requires { &E::lubricant; }) d.lubricant = &E::lubricant;
  if constexpr (requires { &E::moment; }) d.moment = &E::moment;
  if constexpr (requires { &E::unit_moment; }) {
    static_assert(E::parameters.size() == 1, "unit_moment belongs to one linear parameter");
    d.unit_moment = &E::unit_moment;
  }
  if constexpr (requires { &E::reading; }) {
    d.reading = &E::reading;
    d.for_shaft = false;
  }
  if constexpr (requires { &E::displacement; }) {
    d.displacement = &E::displacement;
    d.for_bearing = false;
  }
  if constexpr (requires { E::friction_alone; }) d.friction_alone = E::friction_alone;
  if constexpr (requires { E::subject; }) {
    d.for_bearing = E::subject == Subject::bearing;
    d.for_shaft = E::subject == Subject::shaft;
  }
  return d;
}

template <typename... E>
constexpr std::array<Description, sizeof...(E)> describe_all(const std::tuple<E...>*) {
  return {describe<E>()...};
}

constexpr auto descriptions = describe_all(static_cast<const Catalogue*>(nullptr));

/// True where `k` is the form of its effect for that subject, or the only one.
constexpr bool is_form_for(Subject subject, std::size_t k) {
  if (descriptions[k].belongs_to(subject)) return true;
  for (const Description& other : descriptions)
    if (other.id == descriptions[k].id && other.belongs_to(subject)) return false;
  return true;
}

constexpr std::size_t count_for(Subject subject) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < descriptions.size(); ++k) count += is_form_for(subject, k) ? 1 : 0;
  return count;
}

template <Subject subject>
constexpr auto forms_for() {
  std::array<Description, count_for(subject)> list;
  std::size_t count = 0;
  for (std::size_t k = 0; k < descriptions.size(); ++k)
    if (is_form_for(subject, k)) list[count++] = descriptions[k];
  return list;
}

constexpr auto of_bearing = forms_for<Subject::bearing>();
constexpr auto of_shaft = forms_for<Subject::shaft>();

}  // namespace

std::span<const Description> all_forms() { return descriptions; }

std::span<const Description> catalogue(Subject subject) {
  if (subject == Subject::bearing) return of_bearing;
  return of_shaft;
}

const Description* find(std::string_view id, Subject subject) {
  for (const Description& d : catalogue(subject))
    if (d.id == id) return &d;
  return nullptr;
}

std::string_view text(Need need) {
  switch (need) {
    case Need::speed_levels:
      return "more than one speed";
    case Need::load_levels:
      return "more than one load";
    case Need::preload_levels:
      return "more than one preload (preload_N)";
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
    case Need::opposed_sets:
      return "bearings at both ends of the shaft: a tandem hangs on its spring";
    case Need::torque_standard:
      return "a known torque to compare with: torque alone cannot tell it from a common factor on "
             "all moments";
  }
  return "";
}

bool Condition::finite() const {
  return std::isfinite(extra_axial_load) && std::isfinite(radial_growth) && std::isfinite(tilt) &&
         std::isfinite(other_balls) && std::isfinite(other_mounting);
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
