#include "effects/catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "effects/all_effects.h"
#include "effects/formula.h"

namespace raceway::effects {
namespace {

/// An effect takes the steps that its struct has.
template <typename E>
constexpr Description describe() {
  Description d;
  d.id = E::id;
  d.title = E::title;
  d.mechanism = E::mechanism;
  d.formula = E::formula;
  d.source = E::source;
  d.confused_with = E::confused_with;
  d.parameters = E::parameters;
  d.needs = E::needs;
  if constexpr (requires { E::channels; }) d.channels = E::channels;
  if constexpr (requires { E::supplies; }) d.supplies = E::supplies;
  if constexpr (requires { E::needs_equilibrium; }) d.needs_equilibrium = E::needs_equilibrium;
  if constexpr (requires { E::uses_power; }) d.uses_power = E::uses_power;
  if constexpr (requires { E::uses_room; }) d.uses_room = E::uses_room;
  if constexpr (requires { E::within_contacts; }) d.within_contacts = E::within_contacts;
  if constexpr (requires { E::within_oil_fraction; })
    d.within_oil_fraction = E::within_oil_fraction;
  if constexpr (requires { E::of_viscous_moment; }) d.of_viscous_moment = E::of_viscous_moment;
  if constexpr (requires { E::not_for_rollers; }) d.not_for_rollers = E::not_for_rollers;
  if constexpr (requires { E::bearing_data; }) d.bearing_data = E::bearing_data;
  if constexpr (requires { E::drags_on_the_rotor; }) d.drags_on_the_rotor = E::drags_on_the_rotor;
  if constexpr (requires { E::base_law; }) d.base_law = E::base_law;
  if constexpr (requires { E::empirical; }) d.empirical = E::empirical;
  if constexpr (requires { E::spin; }) d.spin = E::spin;
  if constexpr (requires { E::size_power; }) d.size_power = E::size_power;
  if constexpr (requires { E::follows_heat; }) d.follows_heat = E::follows_heat;
  if constexpr (requires { E::datum; }) d.datum = E::datum;
  if constexpr (requires { &E::correction; }) d.correction = &E::correction;
  if constexpr (requires { E::settled_by; }) d.settled_by = E::settled_by;
  if constexpr (requires { &E::entry; }) d.entry = &E::entry;
  if constexpr (requires { &E::condition; }) d.condition = &E::condition;
  if constexpr (requires { &E::lubricant; }) d.lubricant = &E::lubricant;
  if constexpr (requires { &E::lubricant_by_tangents; })
    d.lubricant_by_tangents = &E::lubricant_by_tangents;
  if constexpr (requires { &E::moment; }) d.moment = &E::moment;
  if constexpr (requires { &E::unit_moment; }) {
    static_assert(
        E::parameters.size() == 1,
        "an effect with unit_moment has a single parameter, and its moment is proportional to it");
    d.unit_moment = &E::unit_moment;
  }
  if constexpr (requires { &E::reading; }) {
    static_assert(E::channel.role == record::Role::measured);
    d.reading = &E::reading;
    d.channel = &E::channel;
    d.for_rig = E::channel == record::friction_torque;
    d.for_spindle = !d.for_rig;
  }
  if constexpr (requires { &E::spindle; }) d.spindle = &E::spindle;
  if constexpr (requires { E::friction_alone; }) d.friction_alone = E::friction_alone;
  if constexpr (requires { E::as_mounted; }) d.as_mounted = E::as_mounted;
  if constexpr (requires { E::of_each_record; }) d.of_each_record = E::of_each_record;
  if constexpr (requires { E::form; }) {
    d.for_rig = E::form == Form::rig;
    d.for_shaft = E::form == Form::shaft;
    d.for_spindle = E::form != Form::rig;
  }
  if constexpr (requires { E::for_spindle; }) d.for_spindle = E::for_spindle;
  return d;
}

template <typename... E>
constexpr std::array<Description, sizeof...(E)> describe_all(const std::tuple<E...>*) {
  return {describe<E>()...};
}

constexpr auto descriptions = describe_all(static_cast<const Catalogue*>(nullptr));

/// True where `k` is that form of its effect, or the first one where it has no such form.
constexpr bool is_form_for(Form form, std::size_t k) {
  if (descriptions[k].belongs_to(form)) return true;
  for (std::size_t other = 0; other < descriptions.size(); ++other)
    if (other != k && descriptions[other].id == descriptions[k].id &&
        (other < k || descriptions[other].belongs_to(form)))
      return false;
  return true;
}

constexpr std::size_t count_for(Form form) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < descriptions.size(); ++k) count += is_form_for(form, k) ? 1 : 0;
  return count;
}

template <Form form>
constexpr auto forms_for() {
  std::array<Description, count_for(form)> list;
  std::size_t count = 0;
  for (std::size_t k = 0; k < descriptions.size(); ++k)
    if (is_form_for(form, k)) list[count++] = descriptions[k];
  return list;
}

constexpr auto of_rig = forms_for<Form::rig>();
constexpr auto of_shaft = forms_for<Form::shaft>();
constexpr auto of_spindle = forms_for<Form::spindle>();

}  // namespace

std::span<const Description> all_forms() { return descriptions; }

std::span<const Description> catalogue(Form form) {
  if (form == Form::rig) return of_rig;
  if (form == Form::shaft) return of_shaft;
  return of_spindle;
}

std::string_view name(Form form) {
  return form == Form::rig ? "rig" : form == Form::shaft ? "shaft" : "spindle";
}

const Description* find(std::string_view id, Form form) {
  for (const Description& d : catalogue(form))
    if (d.id == id) return &d;
  return nullptr;
}

std::string_view text(Need need) {
  switch (need) {
    case Need::speed_levels:
      return "more than one speed";
    case Need::load_levels:
      return "more than one load (axial or radial)";
    case Need::preload_levels:
      return "more than one preload (preload_N)";
    case Need::viscosity_levels:
      return "more than one temperature";
    case Need::time:
      return "time_s of every row";
    case Need::ring_temperatures:
      return "inner_ring_temperature_C and outer_ring_temperature_C of every row";
    case Need::loads:
      return "a load in every row, for the equilibrium of the balls";
    case Need::several_axial_loads:
      return "more than one axial load";
    case Need::several_bearings:
      return "bearings = 2 or more under [rig]: a set with preload";
    case Need::rising_and_falling:
      return "rows with rising and rows with falling speed, with time_s";
    case Need::ball_load_law:
      return "the law contact or contact-powers, or an effect that uses the ball loads, such as "
             "spin-friction: the other base laws depend only on the bearing load";
    case Need::palmgren_law:
      return "a base law other than skf or table: the skf law already contains this effect, and a "
             "friction table may contain it";
    case Need::opposed_sets:
      return "bearings at both ends of the shaft: in a tandem, a spring keeps the preload constant";
    case Need::torque_standard:
      return "a known reference torque: the measured torque alone does not separate this effect "
             "from a common factor on all moments";
    case Need::cold_friction:
      return "a model whose friction uses the forces of the cold bearing sets (preload_feedback = "
             "false): the forces of the warm bearing sets already include the effect";
  }
  return "";
}

std::string text(const record::Channel& channel) {
  return std::string(channel.name) + " of every row";
}

std::string text(std::span<const friction::Supply> supplies) {
  std::string list;
  for (const friction::Supply supply : supplies) {
    list += list.empty() ? "" : supply == supplies.back() ? " or " : ", ";
    list += friction::words(supply);
  }
  return list;
}

double Record::value(const record::Channel& channel) const {
  if (channel == record::time) return time;
  if (channel == record::inner_ring_temperature) return inner_ring_temperature;
  if (channel == record::outer_ring_temperature) return outer_ring_temperature;
  return rows ? rows->value(channel, row) : unset;
}

bool Condition::finite() const {
  return std::isfinite(extra_axial_load) && std::isfinite(radial_growth) && std::isfinite(tilt) &&
         std::isfinite(other_balls) && std::isfinite(other_mounting) &&
         std::isfinite(preload_error);
}

bool Requirements::works_with(std::optional<friction::Supply> supply) const {
  return !supply || supplies.empty() ||
         std::find(supplies.begin(), supplies.end(), *supply) != supplies.end();
}

std::string_view Actions::step() const {
  if (entry) return "entry";
  if (condition) return "condition";
  if (lubricant) return "lubricant";
  if (has_moment()) return "moment";
  return reading ? "reading" : "spindle";
}

double Effect::moment(const MomentInputs& inputs) const {
  const Description& d = *description;
  if (d.unit_moment) return values[0] * d.unit_moment(inputs);
  if (d.moment) return d.moment(inputs, values);
  return d.user_made ? d.user_made->moment(inputs, values) : 0.0;
}

SpindleCondition spindle_condition(std::span<const Effect> effects) {
  SpindleCondition condition;
  for (const Effect& effect : effects)
    if (effect.description->spindle) effect.description->spindle(effect.values, condition);
  return condition;
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
