#include "effects/formula.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace raceway::effects {
namespace {

using Variable = Formula::Variable;
using In = MomentInputs;

constexpr std::array known_variables{
    Variable{"speed_rpm", "shaft speed", [](const In& i) { return i.state.speed / rpm; }},
    Variable{"axial_load_N", "axial load of one bearing",
             [](const In& i) { return i.state.axial_load; }},
    Variable{"radial_load_N", "radial load of one bearing",
             [](const In& i) { return i.state.radial_load; }},
    Variable{"temperature_C", "temperature of the row",
             [](const In& i) { return celsius(i.state.temperature); }},
    Variable{"viscosity_mm2_s", "kinematic viscosity of the film",
             [](const In& i) { return i.state.kinematic_viscosity / mm2_per_s; }},
    Variable{"time_s", "time by the clock of the file", nullptr, &record::time},
    Variable{"inner_ring_temperature_C", "measured with the row", nullptr,
             &record::inner_ring_temperature},
    Variable{"outer_ring_temperature_C", "measured with the row", nullptr,
             &record::outer_ring_temperature},
    Variable{"load_torque_Nmm", "load moment of the base law",
             [](const In& i) { return i.base.load / N_mm; }},
    Variable{"viscous_torque_Nmm", "viscous moment of the base law",
             [](const In& i) { return i.base.viscous / N_mm; }},
    Variable{"pitch_diameter_mm", "of the bearing",
             [](const In& i) { return i.state.bearing->geometry().pitch_diameter / mm; }},
    Variable{"ball_diameter_mm", "of the bearing",
             [](const In& i) { return i.state.bearing->geometry().ball_diameter / mm; }},
    Variable{
        "ball_count", "of the bearing",
        [](const In& i) { return static_cast<double>(i.state.bearing->geometry().ball_count); }},
    Variable{"contact_angle_deg", "of the bearing",
             [](const In& i) { return i.state.bearing->geometry().contact_angle / degree; }},
    Variable{"static_load_rating_N", "of the bearing",
             [](const In& i) { return i.state.bearing->geometry().static_load_rating; }}};

/// What variables tell of the bearing, as Description::bearing_data names it.
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

/// What muParser takes and nobody means: several expressions, of which the last would count, and
/// values given to names. Operators of other languages get a hint.
void refuse_what_is_no_formula(const std::string& text) {
  const auto refuse = [](const std::string& what, std::size_t where) {
    throw FormulaError(what, where, "");
  };
  if (const std::size_t at = text.find("**"); at != text.npos)
    refuse("** is no operator here; a power is written x^2", at);
  for (std::size_t at = text.find('='); at != text.npos; at = text.find('=', at + 1)) {
    const char before = at > 0 ? text[at - 1] : ' ';
    if (at + 1 < text.size() && text[at + 1] == '=')
      ++at;
    else if (before != '<' && before != '>' && before != '!')
      refuse("= gives a value to a name, which a formula cannot; == compares", at);
  }
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (text[at] == ',' && depth <= 0)
      refuse("a comma stands between the arguments of a function only; decimals have a point, 1.5",
             at);
    if (text[at] == ';') refuse("a formula is one expression, without ;", at);
  }
}

}  // namespace

/// A parser and the numbers it looks at; muParser keeps them by address.
struct Formula::Instance {
  mu::Parser parser;
  std::vector<double> numbers;
  std::vector<std::size_t> used;  ///< of the variables

  Instance(const std::string& text, const std::vector<std::string>& parameters)
      : numbers(variable_list.size() + parameters.size(), 1.0) {
    std::size_t k = 0;
    for (const Variable& v : variable_list) parser.DefineVar(std::string(v.name), &numbers[k++]);
    for (const std::string& name : parameters) parser.DefineVar(name, &numbers[k++]);
    parser.SetExpr(text);
    (void)parser.Eval();
    for (const auto& [name, address] : parser.GetUsedVar()) {
      const auto index = static_cast<std::size_t>(address - numbers.data());
      if (index < variable_list.size()) used.push_back(index);
    }
  }
};

/// Parsers at rest. A thread takes one and puts it back, so that none is shared.
struct Formula::Pool {
  std::mutex lock;
  std::vector<std::unique_ptr<Instance>> at_rest;
};

Formula::Formula(std::string text, std::vector<std::string> parameters)
    : text_(std::move(text)), parameters_(std::move(parameters)), pool_(new Pool) {
  refuse_what_is_no_formula(text_);
  try {
    pool_->at_rest.push_back(std::make_unique<Instance>(text_, parameters_));
  } catch (const mu::Parser::exception_type& error) {
    const bool unknown = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN;
    const int position = error.GetPos();
    const std::string token = error.GetToken();
    std::string message = error.GetMsg();
    if (unknown) message = "\"" + token + "\" is not known";
    throw FormulaError(
        message,
        position < 0 ? text_.size() : std::min(static_cast<std::size_t>(position), text_.size()),
        unknown ? token : "");
  }
}

Formula::~Formula() = default;

bool Formula::uses(std::string_view variable) const {
  const std::lock_guard hold(pool_->lock);
  const std::vector<std::size_t>& used = pool_->at_rest.front()->used;
  return std::any_of(used.begin(), used.end(),
                     [&](std::size_t k) { return variable_list[k].name == variable; });
}

bool Formula::is_size(std::size_t parameter, std::span<const double> values) const {
  Instance mine(text_, parameters_);
  const auto moments = [&](double size) {
    std::vector<double> result;
    for (const double input : {0.3, 2.0, 70.0, 5000.0}) {
      for (std::size_t k = 0; k < variable_list.size(); ++k)
        mine.numbers[k] = input * (1.0 + 0.1 * static_cast<double>(k));
      for (std::size_t k = 0; k < values.size(); ++k)
        mine.numbers[variable_list.size() + k] =
            k == parameter ? size : (values[k] == 0.0 ? 1.0 : values[k]);
      try {
        result.push_back(mine.parser.Eval());
      } catch (const mu::Parser::exception_type&) {
        result.push_back(unset);
      }
    }
    return result;
  };
  const auto is_zero = [](double m) { return m == 0.0; };
  const std::vector<double> off = moments(0.0), on = moments(1.0);
  return std::all_of(off.begin(), off.end(), is_zero) &&
         !std::all_of(on.begin(), on.end(), is_zero);
}

double Formula::moment(const MomentInputs& inputs, std::span<const double> values) const {
  std::unique_ptr<Instance> mine;
  {
    const std::lock_guard hold(pool_->lock);
    // The first stays, as the one that uses() looks at.
    if (pool_->at_rest.size() > 1) {
      mine = std::move(pool_->at_rest.back());
      pool_->at_rest.pop_back();
    }
  }
  if (!mine) mine = std::make_unique<Instance>(text_, parameters_);
  for (const std::size_t k : mine->used) mine->numbers[k] = variable_list[k].value(inputs);
  for (std::size_t k = 0; k < values.size(); ++k)
    mine->numbers[variable_list.size() + k] = values[k];
  double result = unset;
  try {
    result = mine->parser.Eval() * N_mm;
  } catch (const mu::Parser::exception_type&) {
    // No number at this point, as where an argument is out of range: NaN says so.
  }
  const std::lock_guard hold(pool_->lock);
  pool_->at_rest.push_back(std::move(mine));
  return result;
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
  std::unique_ptr<Formula> formula;
  Description description;
};

}  // namespace

Effect make_effect(const UserMadeEffect& given) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto owner = std::make_shared<Owner>();
  owner->given = given;
  std::vector<std::string> names;
  for (const UserMadeEffect::Number& n : owner->given.parameters) names.push_back(n.name);
  owner->formula = std::make_unique<Formula>(given.torque_Nmm, std::move(names));
  Effect effect;
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
    effect.values.push_back(n.value);
  }
  const Formula& f = *owner->formula;
  for (std::size_t k = 0; k < owner->parameters.size(); ++k) {
    Parameter& p = owner->parameters[k];
    if (p.lower > 0.0 || p.upper < 0.0 || !f.is_size(k, effect.values)) continue;
    p.neutral = 0.0;
    break;  // one size; what multiplies it is shape
  }
  if (f.uses("time_s")) owner->needs.push_back(Need::time);
  if (f.uses("inner_ring_temperature_C") || f.uses("outer_ring_temperature_C"))
    owner->needs.push_back(Need::ring_temperatures);
  for (const Variable& v : Formula::variables().subspan(known_variables.size()))
    if (f.uses(v.name)) owner->channels.push_back(v.channel);
  for (const auto& [variable, datum] : bearing_variables)
    if (f.uses(variable)) owner->bearing_data.push_back(datum);
  if (owner->given.title.empty()) owner->given.title = "formula of the model file";
  owner->description = {.id = owner->given.id,
                        .title = owner->given.title,
                        .mechanism = "Written as a formula in the model file.",
                        .formula = owner->given.torque_Nmm,
                        .source = "the user",
                        .confused_with = {},
                        .parameters = owner->parameters,
                        .needs = owner->needs,
                        .channels = owner->channels,
                        .bearing_data = owner->bearing_data};
  owner->description.user_made = owner->formula.get();
  effect.description = &owner->description;
  effect.owner = owner;
  return effect;
}

}  // namespace raceway::effects
