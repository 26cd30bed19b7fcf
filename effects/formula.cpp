#include "effects/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace raceway::effects {
namespace {

using Variable = Formula::Variable;
using In = MomentInputs;

/// A number of a ball bearing; none where the bearing has cylindrical rollers.
template <typename Number>
double of_balls(const In& i, const Number& number) {
  return i.state.bearing ? static_cast<double>(number(i.state.bearing->geometry())) : unset;
}
using Geometry = bearing::BearingGeometry;

constexpr std::array known_variables{
    Variable{"speed_rpm", "shaft speed", [](const In& i) { return i.state.speed / rpm; }},
    Variable{"axial_load_N", "axial load of one bearing",
             [](const In& i) { return i.state.axial_load; }},
    Variable{"radial_load_N", "radial load of one bearing",
             [](const In& i) { return i.state.radial_load; }},
    Variable{"temperature_C", "lubricant temperature of the row",
             [](const In& i) { return celsius(i.state.temperature); }},
    Variable{"viscosity_mm2_s", "kinematic viscosity of the film",
             [](const In& i) { return i.state.kinematic_viscosity / mm2_per_s; }},
    Variable{"time_s", "time of the row", nullptr, &record::time},
    Variable{"inner_ring_temperature_C", "inner ring temperature of the row", nullptr,
             &record::inner_ring_temperature},
    Variable{"outer_ring_temperature_C", "outer ring temperature of the row", nullptr,
             &record::outer_ring_temperature},
    Variable{"load_torque_Nmm", "load moment of the base law",
             [](const In& i) { return i.base.load / N_mm; }},
    Variable{"viscous_torque_Nmm", "viscous moment of the base law",
             [](const In& i) { return i.base.viscous / N_mm; }},
    Variable{"pitch_diameter_mm", "pitch diameter of the bearing",
             [](const In& i) { return i.state.pitch_diameter() / mm; }},
    Variable{"ball_diameter_mm", "ball diameter of the bearing",
             [](const In& i) {
               return of_balls(i, [](const Geometry& g) { return g.ball_diameter / mm; });
             }},
    Variable{
        "ball_count", "number of balls",
        [](const In& i) { return of_balls(i, [](const Geometry& g) { return g.ball_count; }); }},
    Variable{"contact_angle_deg", "nominal contact angle of the bearing",
             [](const In& i) {
               return of_balls(i, [](const Geometry& g) { return g.contact_angle / degree; });
             }},
    Variable{"static_load_rating_N", "static load rating C0 of the bearing", [](const In& i) {
               return of_balls(i, [](const Geometry& g) { return g.static_load_rating; });
             }}};

/// What variables tell of the bearing, as Requirements::bearing_data names it.
struct BearingVariable {
  std::string_view variable, datum;
};
constexpr std::array bearing_variables{
    BearingVariable{"pitch_diameter_mm", "pitch_diameter"},
    BearingVariable{"ball_diameter_mm", "ball_diameter"},
    BearingVariable{"ball_count", "ball_count"},
    BearingVariable{"contact_angle_deg", "contact_angle"},
    BearingVariable{"static_load_rating_N", "static_load_rating"}};

/// True for an input of the table of channels that is not among them.
constexpr bool is_further(const record::Channel& channel) {
  return channel.is_input() &&
         std::none_of(known_variables.begin(), known_variables.end(),
                      [&](const Variable& v) { return v.name == channel.name; });
}

constexpr auto variable_list = [] {
  constexpr auto further = static_cast<std::size_t>(
      std::count_if(record::channels.begin(), record::channels.end(), is_further));
  std::array<Variable, known_variables.size() + further> list;
  auto end = std::copy(known_variables.begin(), known_variables.end(), list.begin());
  for (const record::Channel& channel : record::channels)
    if (is_further(channel)) *end++ = {channel.name, channel.words, nullptr, &channel};
  return list;
}();

}  // namespace

std::span<const Variable> Formula::variables() { return variable_list; }

double Formula::Variable::value(const MomentInputs& inputs) const {
  return channel ? channel->in_unit(inputs.record.value(*channel)) : computed(inputs);
}

namespace {

/// Of variables, then of the parameters.
std::vector<std::string> names_with(std::vector<std::string> parameters) {
  std::vector<std::string> names;
  for (const Variable& v : variable_list) names.emplace_back(v.name);
  for (std::string& name : parameters) names.push_back(std::move(name));
  return names;
}

}  // namespace

Formula::Formula(std::string text, std::vector<std::string> parameters)
    : expression_(std::move(text), names_with(std::move(parameters))) {}

bool Formula::uses(std::string_view variable) const {
  return std::any_of(expression_.used().begin(), expression_.used().end(), [&](std::size_t k) {
    return k < variable_list.size() && variable_list[k].name == variable;
  });
}

bool Formula::is_size(std::size_t parameter, std::span<const double> values) const {
  const auto moments = [&](double size) {
    std::vector<double> result, of_used;
    for (const double input : {0.3, 2.0, 70.0, 5000.0}) {
      of_used.clear();
      for (const std::size_t k : expression_.used()) {
        const std::size_t p = k - variable_list.size();
        of_used.push_back(k < variable_list.size() ? input * (1.0 + 0.1 * static_cast<double>(k))
                          : p == parameter         ? size
                          : values[p] == 0.0       ? 1.0
                                                   : values[p]);
      }
      result.push_back(expression_(of_used));
    }
    return result;
  };
  const auto is_zero = [](double m) { return m == 0.0; };
  const std::vector<double> off = moments(0.0), on = moments(1.0);
  return std::all_of(off.begin(), off.end(), is_zero) &&
         !std::all_of(on.begin(), on.end(), is_zero);
}

double Formula::moment(const MomentInputs& inputs, std::span<const double> values) const {
  std::vector<double> of_used;
  of_used.reserve(expression_.used().size());
  for (const std::size_t k : expression_.used())
    of_used.push_back(k < variable_list.size() ? variable_list[k].value(inputs)
                                               : values[k - variable_list.size()]);
  return expression_(of_used) * N_mm;
}

namespace {

/// All that the views of a description point to.
struct Owner {
  UserMadeEffect given;
  std::string source;
  std::vector<Parameter> parameters;
  std::vector<Need> needs;
  std::vector<const record::Channel*> channels;
  std::vector<std::string_view> bearing_data;
  std::unique_ptr<OwnMoment> moment;
  Description description;
};

std::shared_ptr<Owner> owner_of(const UserMadeEffect& given) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  auto owner = std::make_shared<Owner>();
  owner->given = given;
  for (const UserMadeEffect::Number& n : owner->given.parameters) {
    const double lower = std::isnan(n.lower) ? -infinity : n.lower;
    const double upper = std::isnan(n.upper) ? infinity : n.upper;
    owner->parameters.push_back({.name = n.name,
                                 .unit = n.unit,
                                 .initial = n.value,
                                 .lower = lower,
                                 .upper = upper,
                                 .plausible_lower = lower,
                                 .plausible_upper = upper,
                                 .neutral = unset});
  }
  return owner;
}

/// The effect of what stands in its owner. `is_size`: whether zero of a parameter turns it off.
Effect effect_of(const std::shared_ptr<Owner>& owner, std::string_view mechanism,
                 const std::function<bool(std::size_t, std::span<const double>)>& is_size) {
  Effect effect;
  for (const Parameter& p : owner->parameters) effect.values.push_back(p.initial);
  for (std::size_t k = 0; k < owner->parameters.size(); ++k) {
    Parameter& p = owner->parameters[k];
    if (p.lower > 0.0 || p.upper < 0.0 || !is_size(k, effect.values)) continue;
    p.neutral = 0.0;
    break;  // one size; what multiplies it is shape
  }
  if (owner->given.title.empty()) owner->given.title = mechanism;
  Description& d = owner->description;
  d.id = owner->given.id;
  d.title = owner->given.title;
  d.mechanism = mechanism;
  d.formula = owner->given.torque_Nmm;
  d.source = "the user";
  d.parameters = owner->parameters;
  d.needs = owner->needs;
  d.channels = owner->channels;
  d.bearing_data = owner->bearing_data;
  d.user_made = owner->moment.get();
  effect.description = &owner->description;
  effect.owner = owner;
  return effect;
}

}  // namespace

Effect make_effect(const UserMadeEffect& given) {
  const std::shared_ptr<Owner> owner = owner_of(given);
  std::vector<std::string> names;
  for (const UserMadeEffect::Number& n : owner->given.parameters) names.push_back(n.name);
  auto formula = std::make_unique<Formula>(given.torque_Nmm, std::move(names));
  const Formula& f = *formula;
  owner->moment = std::move(formula);
  if (f.uses("time_s")) owner->needs.push_back(Need::time);
  if (f.uses("inner_ring_temperature_C") || f.uses("outer_ring_temperature_C"))
    owner->needs.push_back(Need::ring_temperatures);
  for (const Variable& v : Formula::variables().subspan(known_variables.size()))
    if (f.uses(v.name)) owner->channels.push_back(v.channel);
  for (const auto& [variable, datum] : bearing_variables)
    if (f.uses(variable)) owner->bearing_data.push_back(datum);
  if (owner->given.title.empty()) owner->given.title = "formula of the model file";
  return effect_of(
      owner, "The effect is a formula in the model file.",
      [&](std::size_t k, std::span<const double> values) { return f.is_size(k, values); });
}

Effect make_effect(const UserMadeEffect& given, std::unique_ptr<OwnMoment> moment) {
  const std::shared_ptr<Owner> owner = owner_of(given);
  owner->moment = std::move(moment);
  return effect_of(owner, "The effect is a function that the user wrote.",
                   [](std::size_t, std::span<const double>) { return true; });
}

}  // namespace raceway::effects
