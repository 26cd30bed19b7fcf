#include "model/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "model/judgement.h"
#include "model/sensor_place.h"

namespace raceway::model {
namespace {

using record::Parameter;

/// A number of the bearing that may be fitted, in its file and in its geometry.
struct BearingNumber {
  std::string_view name, unit;
  double bearing::BearingGeometry::*member;
  double factor;
  double lower, upper;
};

constexpr std::array bearing_numbers{
    BearingNumber{"inner_conformity", "1", &bearing::BearingGeometry::inner_conformity, 1.0, 0.5005,
                  0.7},
    BearingNumber{"outer_conformity", "1", &bearing::BearingGeometry::outer_conformity, 1.0, 0.5005,
                  0.7},
    BearingNumber{"contact_angle_deg", "deg", &bearing::BearingGeometry::contact_angle, degree, 1.0,
                  65.0}};

/// A number of what stands around the sets that may be fitted, in units of files as in the model.
struct SpindleNumber {
  std::string_view table, name, unit;
  double lower, upper;
  double& (*in)(Spindle&);
};

constexpr std::array spindle_numbers{
    SpindleNumber{"ambient", "convection_factor", "1", 0.0, 20.0,
                  [](Spindle& s) -> double& { return s.ambient.convection_factor; }},
    SpindleNumber{"bearing", "lubricant_conductance_W_K", "W/K", 0.0, 1000.0,
                  [](Spindle& s) -> double& { return s.lubricant_conductance; }},
    SpindleNumber{"seat", "outer_conductance_W_m2K", "W/(m2 K)", 0.1, 1e6,
                  [](Spindle& s) -> double& { return s.seat.outer_conductance; }},
    SpindleNumber{"housing", "flange_conductance_W_K", "W/K", 0.0, 1e4,
                  [](Spindle& s) -> double& { return s.housing.flange_conductance; }}};

/// The sources of heat of a spindle: [motor], [drive], then [[heat]] in its order. Their numbers
/// are "motor.heat_W", "drive.heat_factor", "NAME.heat_W".
template <typename OfSpindle>
auto heat_sources(OfSpindle& spindle) {
  std::vector<std::pair<decltype(&*spindle.motor), std::string>> list;
  if (spindle.motor) list.emplace_back(&*spindle.motor, "motor");
  if (spindle.drive) list.emplace_back(&*spindle.drive, "drive");
  for (std::size_t k = 0; k < spindle.heat.size(); ++k)
    list.emplace_back(&spindle.heat[k], "heat." + std::to_string(k));
  return list;
}
constexpr std::string_view heat_number = "heat_W", heat_factor = "heat_factor";

/// The one number of a source that may be fitted.
double& number_of(HeatSource& source) { return source.formula ? source.factor : source.watts; }
double number_of(const HeatSource& source) { return source.formula ? source.factor : source.watts; }

/// A number of a coolant circuit that may be fitted.
struct CoolantNumber {
  std::string_view name, unit;
  double (*value)(const Coolant&);         ///< in the unit of the file
  void (*assign)(Coolant&, double value);  ///< in the unit of the file
};

constexpr std::array coolant_numbers{
    CoolantNumber{"inlet_temperature_C", "C",
                  [](const Coolant& c) { return celsius(c.inlet_temperature); },
                  [](Coolant& c, double value) { c.inlet_temperature = kelvin(value); }},
    CoolantNumber{"flow_l_min", "l/min", [](const Coolant& c) { return c.flow / l_per_min; },
                  [](Coolant& c, double value) { c.flow = value * l_per_min; }}};
constexpr const CoolantNumber& inlet_number = coolant_numbers[0];
constexpr double usual_flow_l_min = 5.0, largest_flow_l_min = 1e4;

/// A coolant circuit, the table of the file that has its numbers, and how their names begin.
template <typename OfCoolant>
struct PlacedCircuit {
  OfCoolant* coolant;
  std::string table, prefix;
};

/// The circuits of a spindle: [coolant], then [[coolant.circuit]] in its order. Their numbers are
/// "flow_l_min" and "NAME.flow_l_min".
template <typename OfSpindle>
auto coolant_circuits(OfSpindle& spindle) {
  std::vector<PlacedCircuit<std::remove_reference_t<decltype(*spindle.coolant)>>> list;
  if (spindle.coolant) list.push_back({&*spindle.coolant, "coolant", ""});
  for (std::size_t k = 0; k < spindle.circuits.size(); ++k)
    list.push_back({&spindle.circuits[k].channel, "coolant.circuit." + std::to_string(k),
                    spindle.circuits[k].name + "."});
  return list;
}

constexpr double coldest_oil_C = -50.0, hottest_oil_C = 150.0;  // that a file may say

/// Range of the inlet temperature of a circuit. The inlet of the first circuit is also the inlet of
/// the circuits without their own.
std::pair<double, double> inlet_range(const Spindle& spindle, const Coolant& circuit) {
  const auto follows = [&](const Circuit& c) { return std::isnan(c.channel.inlet_temperature); };
  bool water = circuit.fluid == Fluid::water;
  if (&circuit == &*spindle.coolant)
    for (const Circuit& c : spindle.circuits)
      water = water || (follows(c) && c.channel.fluid == Fluid::water);
  return water ? std::pair(celsius(water_freezes), celsius(water_boils))
               : std::pair(coldest_oil_C, hottest_oil_C);
}

double value_in(const Spindle& spindle, const SpindleNumber& number) {
  return number.in(const_cast<Spindle&>(spindle));  // looked at only
}

std::string address_of(const BearingNumber& number) {
  return "bearing." + std::string(number.name);
}

/// Whether one bearing, that of the model, stands in all places of the arrangement.
bool one_bearing(const Shaft& shaft) {
  const auto bearings = shaft.arrangement.bearings();
  return !shaft.own_bearings &&
         std::all_of(bearings.begin(), bearings.end(), [&](const bearing::MountedBearing& b) {
           return b.bearing == bearings.front().bearing;
         });
}

bool has_preload_force(const Model& model) {
  return model.shaft &&
         std::holds_alternative<bearing::PreloadForce>(model.shaft->arrangement.design().preload);
}

void set_preload(Model& model, double force) {
  bearing::ArrangementDesign design = model.shaft->arrangement.design();
  design.preload = bearing::PreloadForce{force};
  model.shaft->arrangement = bearing::Arrangement(std::move(design));
}

void set_geometry(Model& model, const bearing::BearingGeometry& geometry) {
  const auto changed = std::make_shared<const bearing::Bearing>(geometry, model.bearing.balls(),
                                                                model.bearing.rings());
  if (model.shaft) {
    bearing::ArrangementDesign design = model.shaft->arrangement.design();
    for (auto* set : {&design.front, &design.rear})
      for (bearing::MountedBearing& m : *set) m.bearing = changed;
    model.shaft->arrangement = bearing::Arrangement(std::move(design));
  }
  model.bearing = *changed;
}

/// A number at these addresses; start and value are those of the model.
Parameter parameter_at(const Model& model, std::vector<std::string> addresses, std::string name,
                       std::string_view unit, double lower, double upper) {
  Parameter p;
  p.name = std::move(name);
  p.unit = unit;
  p.addresses = std::move(addresses);
  p.lower = lower;
  p.upper = upper;
  p.start = p.value = p.initial = get(model, p);
  return p;
}

void add(std::vector<Parameter>& list, Parameter p) {
  p.scale = record::typical_size(p.start, p.initial, p.lower, p.upper);
  list.push_back(std::move(p));
}

/// In which table of a file a number of the law stands.
std::string table_of(const friction::Parameter& number) {
  return friction::of_the_lubricant(number) ? "lubricant" : "friction";
}

void add_law(std::vector<Parameter>& list, const Model& model) {
  for (const friction::Parameter& n : friction::parameters(model.law)) {
    const std::string name(n.name);
    Parameter p = parameter_at(model, {table_of(n) + "." + name}, name, n.unit, n.lower, n.upper);
    p.initial = n.initial;
    // Makers give z for the load P0.
    if (name != "z" || model.f1_load == friction::F1Load::P0) {
      p.plausible_lower = n.plausible_lower;
      p.plausible_upper = n.plausible_upper;
    }
    add(list, std::move(p));
  }
}

void add_arrangement(std::vector<Parameter>& list, const Model& model) {
  if (has_preload_force(model))
    add(list, parameter_at(model, {"arrangement.preload_N"}, "preload_N", "N", 0.001, 1e8));
  if (!model.shaft || !one_bearing(*model.shaft)) return;
  const auto& [inner, outer, angle] = bearing_numbers;
  const auto add_number = [&](std::string_view name, std::vector<std::string> addresses,
                              const BearingNumber& n) {
    add(list,
        parameter_at(model, std::move(addresses), std::string(name), n.unit, n.lower, n.upper));
  };
  const bearing::BearingGeometry& g = model.bearing.geometry();
  add_number(inner.name, {address_of(inner)}, inner);
  add_number(outer.name, {address_of(outer)}, outer);
  if (g.inner_conformity == g.outer_conformity)
    add_number("conformity", {address_of(inner), address_of(outer)}, inner);
  if (g.contact_angle > 0.0) add_number(angle.name, {address_of(angle)}, angle);
}

void add_spindle(std::vector<Parameter>& list, const Model& model) {
  if (!model.spindle) return;
  for (const SpindleNumber& n : spindle_numbers) {
    if (std::isnan(value_in(*model.spindle, n))) continue;
    // Bodies that a file lists itself have no air, seats and flange.
    if (model.spindle->network && n.table != "bearing") continue;
    std::string address(n.table);
    address.append(".").append(n.name);
    add(list,
        parameter_at(model, {std::move(address)}, std::string(n.name), n.unit, n.lower, n.upper));
  }
  if (model.spindle->network) return;
  for (const auto& [coolant, table, prefix] : coolant_circuits(*model.spindle))
    for (const CoolantNumber& n : coolant_numbers) {
      if (std::isnan(n.value(*coolant))) continue;  // the inlet is that of the first circuit
      const bool inlet = &n == &inlet_number;
      const auto [lower, upper] =
          inlet ? inlet_range(*model.spindle, *coolant) : std::pair(0.0, largest_flow_l_min);
      const std::string name(n.name);
      Parameter p = parameter_at(model, {table + "." + name}, prefix + name, n.unit, lower, upper);
      if (!inlet) p.initial = usual_flow_l_min;
      add(list, std::move(p));
    }
  for (const auto& [source, table] : heat_sources(*model.spindle)) {
    const std::string key(source->formula ? heat_factor : heat_number);
    Parameter p = parameter_at(model, {table + "." + key}, source->name + "." + key,
                               source->formula ? "1" : "W", 0.0, source->formula ? 100.0 : 1e6);
    p.initial = source->formula ? 1.0 : 50.0;
    add(list, std::move(p));
  }
  for (std::size_t k = 0; k < model.spindle->sensors.size(); ++k) {
    const ThermometerPlace& sensor = model.spindle->sensors[k];
    const auto [from, to] = reach_of(model, sensor);
    if (from < to)
      add(list, parameter_at(model, {"sensor." + std::to_string(k) + ".position_mm"},
                             "sensor." + sensor.name + ".position_mm", "mm", from / mm, to / mm));
  }
}

void add_effect(std::vector<Parameter>& list, const Model& model, std::size_t k) {
  const effects::Description& d = *model.effects[k].description;
  for (const effects::Parameter& n : d.parameters) {
    const std::string name(n.name);
    Parameter p = parameter_at(model, {"effect." + std::to_string(k) + "." + name},
                               std::string(d.id) + "." + name, n.unit, n.lower, n.upper);
    p.initial = n.initial;
    std::tie(p.plausible_lower, p.plausible_upper) = plausible_range(d, n, model);
    p.neutral = n.neutral;
    // Another record may have given it the value it has.
    const auto [lower, upper] = bounds_of(n, model);
    p.lower = std::min(lower, p.value);
    p.upper = std::max(upper, p.value);
    add(list, std::move(p));
  }
}

[[noreturn]] void refuse(const std::string& address) {
  throw std::invalid_argument(address + ": the model has no number of this name");
}

/// Index of the number of that name.
template <typename Numbers>
std::size_t index_of(const Numbers& numbers, std::string_view name, const std::string& address) {
  const auto found =
      std::find_if(numbers.begin(), numbers.end(), [&](const auto& n) { return n.name == name; });
  if (found == numbers.end()) refuse(address);
  return static_cast<std::size_t>(found - numbers.begin());
}

}  // namespace

std::vector<Parameter> parameters(const Model& model) {
  std::vector<Parameter> list;
  add_law(list, model);
  add_arrangement(list, model);
  add_spindle(list, model);
  for (std::size_t k = 0; k < model.effects.size(); ++k) add_effect(list, model, k);
  return list;
}

std::pair<double, double> bounds_of(const effects::Parameter& number, const Model& model) {
  if (!number.of_the_record || std::isnan(model.coldest)) return {number.lower, number.upper};
  return {celsius(model.coldest), celsius(model.hottest)};
}

std::pair<double, double> plausible_range(const effects::Description& effect,
                                          const effects::Parameter& number, const Model& model) {
  if (effect.drags_on_the_rotor && model.rig.coasts_down())
    return {number.plausible_lower, number.upper};
  if (effect.size_power == 0.0 || std::isnan(number.neutral))
    return {number.plausible_lower, number.plausible_upper};
  const double larger =
      std::pow(model.bearing.pitch_diameter() / effects::size_of_ranges, effect.size_power);
  return {std::clamp(larger * number.plausible_lower, number.lower, number.upper),
          std::clamp(larger * number.plausible_upper, number.lower, number.upper)};
}

ParameterPlace::ParameterPlace(const Model& model, const Parameter& parameter) {
  if (parameter.addresses.empty()) refuse(parameter.name);
  for (const std::string& address : parameter.addresses) resolve(model, address);
}

void ParameterPlace::resolve(const Model& model, const std::string& address) {
  const std::string_view text = address;
  const std::size_t dot = text.find('.');
  if (dot == text.npos) refuse(address);
  const std::string_view table = text.substr(0, dot);
  std::string_view name = text.substr(dot + 1);
  if (model.spindle && table == "sensor") {
    const char* const last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data(), last, index_);
    if (error != std::errc() ||
        std::string_view(end, static_cast<std::size_t>(last - end)) != ".position_mm" ||
        index_ >= model.spindle->sensors.size())
      refuse(address);
    kind_ = Kind::sensor;
    return;
  }
  if (model.spindle) {
    const auto circuits = coolant_circuits(*model.spindle);
    for (std::size_t k = 0; k < circuits.size() * coolant_numbers.size(); ++k) {
      const auto& place = circuits[k / coolant_numbers.size()];
      const CoolantNumber& number = coolant_numbers[k % coolant_numbers.size()];
      if (address != place.table + "." + std::string(number.name) ||
          std::isnan(number.value(*place.coolant)))
        continue;
      kind_ = Kind::coolant;
      index_ = k;
      return;
    }
    const auto sources = heat_sources(*model.spindle);
    for (std::size_t k = 0; k < sources.size(); ++k) {
      const auto& [source, place] = sources[k];
      if (address != place + "." + std::string(source->formula ? heat_factor : heat_number))
        continue;
      kind_ = Kind::heat;
      index_ = k;
      return;
    }
  }
  const auto of_spindle = std::find_if(
      spindle_numbers.begin(), spindle_numbers.end(),
      [&](const SpindleNumber& n) { return model.spindle && n.table == table && n.name == name; });
  if (of_spindle != spindle_numbers.end()) {
    kind_ = Kind::spindle;
    index_ = static_cast<std::size_t>(of_spindle - spindle_numbers.begin());
  } else if (table == "friction" || table == "lubricant") {
    kind_ = Kind::law;
    index_ = index_of(friction::parameters(model.law), name, address);
  } else if (table == "arrangement" && name == "preload_N" && has_preload_force(model)) {
    kind_ = Kind::preload;
  } else if (table == "bearing" && model.bearing.ball_bearing() &&
             !(model.shaft && !one_bearing(*model.shaft))) {
    kind_ = Kind::bearing;
    const BearingNumber& number = bearing_numbers[index_of(bearing_numbers, name, address)];
    members_.push_back(number.member);
    factor_ = number.factor;
  } else if (table == "effect") {
    kind_ = Kind::effect;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), effect_);
    if (error != std::errc() || end == name.data() + name.size() || *end != '.' || effect_ < 0 ||
        static_cast<std::size_t>(effect_) >= model.effects.size())
      refuse(address);
    name.remove_prefix(static_cast<std::size_t>(end - name.data()) + 1);
    index_ = index_of(model.effects[static_cast<std::size_t>(effect_)].description->parameters,
                      name, address);
  } else {
    refuse(address);
  }
}

double ParameterPlace::get(const Model& model) const {
  switch (kind_) {
    case Kind::law:
      return model.law_values.at(index_);
    case Kind::effect:
      return model.effects.at(static_cast<std::size_t>(effect_)).values.at(index_);
    case Kind::preload:
      return std::get<bearing::PreloadForce>(model.shaft->arrangement.design().preload).force;
    case Kind::bearing:
      return model.bearing.geometry().*members_.front() / factor_;
    case Kind::spindle:
      return value_in(*model.spindle, spindle_numbers[index_]);
    case Kind::coolant:
      return coolant_numbers[index_ % coolant_numbers.size()].value(
          *coolant_circuits(*model.spindle)[index_ / coolant_numbers.size()].coolant);
    case Kind::heat:
      return number_of(*heat_sources(*model.spindle)[index_].first);
    case Kind::sensor:
      return model.spindle->sensors.at(index_).position / mm;
  }
  return unset;
}

void ParameterPlace::set(Model& model, double value) const {
  switch (kind_) {
    case Kind::law:
      model.law_values.at(index_) = value;
      return;
    case Kind::effect:
      model.effects.at(static_cast<std::size_t>(effect_)).values.at(index_) = value;
      return;
    case Kind::preload:
      if (value != get(model)) set_preload(model, value);
      return;
    case Kind::bearing: {
      // As it reads back: a value that was read is no change.
      bearing::BearingGeometry g = model.bearing.geometry();
      if (std::all_of(members_.begin(), members_.end(),
                      [&](auto member) { return g.*member / factor_ == value; }))
        return;
      for (const auto member : members_) g.*member = value * factor_;
      set_geometry(model, g);
      return;
    }
    case Kind::spindle:
      spindle_numbers[index_].in(*model.spindle) = value;
      return;
    case Kind::coolant:
      coolant_numbers[index_ % coolant_numbers.size()].assign(
          *coolant_circuits(*model.spindle)[index_ / coolant_numbers.size()].coolant, value);
      return;
    case Kind::heat:
      number_of(*heat_sources(*model.spindle)[index_].first) = value;
      return;
    case Kind::sensor:
      model.spindle->sensors.at(index_).position = value * mm;
      return;
  }
}

double get(const Model& model, const Parameter& parameter) {
  return ParameterPlace(model, parameter).get(model);
}

void set(Model& model, const Parameter& parameter, double value) {
  ParameterPlace(model, parameter).set(model, value);
}

std::vector<std::string> default_free(friction::FrictionLaw law) {
  if (law == friction::FrictionLaw::palmgren) return {"f0", "z"};
  if (friction::has_fitted_exponents(law))
    return {"f0", "z", "y", "viscous_exponent", "viscous_load_exponent"};
  if (law == friction::FrictionLaw::contact) return {"rolling_factor"};
  if (law == friction::FrictionLaw::roller_palmgren) return {"f0", "f1"};
  if (law == friction::FrictionLaw::table) return {"scale"};
  return {"mu_EHL", "K_rs"};
}

std::vector<std::string> default_free(const Model& model) {
  if (model.spindle) return {default_free(model.law).front()};
  if (has_preload_force(model)) return {"preload_N"};
  return default_free(model.law);
}

}  // namespace raceway::model
