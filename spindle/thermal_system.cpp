#include "spindle/thermal_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "model/rings.h"
#include "spindle/contact.h"
#include "spindle/film.h"
#include "spindle/press_fit.h"

namespace raceway::spindle {
namespace {

/// Of turned steel: shaft and bore of the housing [1].
constexpr double steel_emissivity = 0.3;

double area_of(const Joints& joints) {
  double sum = 0.0;
  for (const Joint& j : joints) sum += j.area;
  return sum;
}

/// Mean temperature of the cells at some faces, by area.
double surface(const Joints& joints, const Vector& temperatures) {
  double sum = 0.0, area = 0.0;
  for (const Joint& j : joints) {
    sum += j.area * temperatures[j.first];
    area += j.area;
  }
  return area > 0.0 ? sum / area : unset;
}

Shares by_area(const Joints& joints) {
  const double area = area_of(joints);
  Shares shares;
  for (const Joint& j : joints) shares.push_back({j.first, j.area / area});
  return shares;
}

/// Heat of a source under these inputs [W]. Throws std::invalid_argument where its formula has no
/// number there.
double heat_of(const model::HeatSource& source, const model::Spindle& spindle,
               const Inputs& inputs) {
  if (!std::isnan(source.watts)) return source.watts;
  double belt = inputs.belt_force;
  if (std::isnan(belt)) belt = spindle.belt ? spindle.belt->force : 0.0;
  const std::array<double, 6> values{
      inputs.speed / rpm, inputs.axial_load, inputs.radial_load, inputs.moment, belt,
      inputs.motor_power};
  std::vector<double> used;
  for (const std::size_t k : source.formula->used()) {
    if (std::isnan(values[k]))
      throw std::invalid_argument(fmt::format("heat of {}: \"{}\" needs {}, which is not given",
                                              source.name, source.formula->text(),
                                              model::heat_variables[k]));
    used.push_back(values[k]);
  }
  return source.factor * (*source.formula)(used);
}

double in_series(double half, double film, double area) {
  return film > 0.0 ? 1.0 / (half + 1.0 / (film * area)) : 0.0;
}

}  // namespace

double mean(const Shares& shares, const Vector& temperatures) {
  double sum = 0.0;
  for (const Share& s : shares) sum += s.share * temperatures[s.cell];
  return sum;
}

ThermalSystem::ThermalSystem(const model::Model& model, const effects::SpindleCondition& condition,
                             model::Cells cells)
    : spindle_(*model.spindle), condition_(condition), layout_(make_layout(model, cells)) {
  const auto n = static_cast<Eigen::Index>(layout_.mesh.size());
  for (const model::Coolant& c : spindle_.channels())
    circuits_.push_back({.channel = c, .node = static_cast<int>(n + std::ssize(circuits_))});
  paths_.capacity.setZero(n + std::ssize(circuits_));
  for (Eigen::Index k = 0; k < n; ++k)
    paths_.capacity[k] = layout_.mesh.cells[static_cast<std::size_t>(k)].heat_capacity();
  paths_.source.setZero(paths_.size());
  for (std::size_t k = 0; k < circuits_.size(); ++k) {
    const model::Coolant& c = circuits_[k].channel;
    const Channel channel = channel_of(c);
    const FluidProperties fluid = fluid_properties(c.fluid, inlet(circuits_[k], {}));
    paths_.capacity[circuits_[k].node] =
        channel.section * channel.length * fluid.density * fluid.heat_capacity;
  }
  add_fixed();
  for (const BearingPlace& b : layout_.bearings) {
    inner_seats_.push_back(add_links(b.inner_seat));
    seats_.emplace_back();
    outer_seats_.push_back(add_links(b.outer_seat));
  }
  gap_ = add_links(layout_.gap);
  housing_ = add_outlets(layout_.housing_cylinder, Reservoir::air);
  ends_ = add_outlets(layout_.housing_ends, Reservoir::air);
  nose_ = add_outlets(layout_.nose, Reservoir::air);
  rear_ = add_outlets(layout_.rear, Reservoir::air);
  flange_ = add_outlets(layout_.flange, Reservoir::machine);
  if (flange_.area > 0.0)
    set_outlets(flange_,
                condition_.flange_conductance_factor * flange_conductance() / flange_.area);
  for (std::size_t k = 0; k < circuits_.size(); ++k) {
    Circuit& circuit = circuits_[k];
    Joints walls = layout_.coolant_walls[k];
    for (Joint& j : walls) j.second = circuit.node;
    circuit.walls = add_links(walls);
    circuit.flow = paths_.outlets.size();
    paths_.outlets.push_back({circuit.node, Reservoir::coolant, 0.0});
  }
  add_sleeve(condition_);
  const auto diameter = [&](const Joints& joints) {
    double largest = 0.0;
    for (const Joint& j : joints)
      largest = std::max(largest,
                         2.0 * layout_.mesh.cells[static_cast<std::size_t>(j.first)].outer_radius);
    return largest;
  };
  nose_diameter_ = diameter(layout_.nose);
  rear_diameter_ = diameter(layout_.rear);
  place_heat();
}

/// Finds the cells of all sources, those of the model and those that effects may add.
void ThermalSystem::place_heat() {
  using Place = model::HeatSource::Place;
  const auto cells_at = [&](const std::optional<model::HeatSource>& given, Place place,
                            double share) {
    return cells_of(given ? *given
                          : model::HeatSource{.name = {}, .place = place, .rotor_share = share});
  };
  motor_ = cells_at(spindle_.motor, Place::motor, 0.5);
  drive_ = cells_at(spindle_.drive, Place::pulley, 1.0);
  seal_ = cells_at({}, Place::seal, 1.0);
  const std::size_t front = spindle_.front_positions.size();
  const std::size_t sets = front + spindle_.rear_positions.size();
  const double last_of_sets = layout_.bearings[sets - 1].position;
  Joints inner[2], outer[2];
  const bool rollers_behind = std::any_of(
      layout_.bearings.begin() + static_cast<std::ptrdiff_t>(sets), layout_.bearings.end(),
      [&](const BearingPlace& b) { return b.position > last_of_sets; });
  for (std::size_t k = 0; k < layout_.bearings.size(); ++k) {
    const BearingPlace& b = layout_.bearings[k];
    const bool at_the_rear =
        rollers_behind ? k >= sets && b.position > last_of_sets : k >= front && k < sets;
    if (k >= front && !at_the_rear) continue;
    Joints &in = inner[at_the_rear ? 1 : 0], &out = outer[at_the_rear ? 1 : 0];
    in.insert(in.end(), b.inner_raceway.begin(), b.inner_raceway.end());
    out.insert(out.end(), b.outer_raceway.begin(), b.outer_raceway.end());
  }
  front_bearings_ = {by_area(inner[0]), by_area(outer[0]), 0.5};
  rear_bearings_ = {by_area(inner[1]), by_area(outer[1]), 0.5};
  for (const model::HeatSource& source : spindle_.heat) sources_.push_back(cells_of(source));
  source_heat_.assign(sources_.size(), 0.0);
}

ThermalSystem::Group ThermalSystem::add_links(const Joints& joints) {
  Group group{.first = paths_.links.size(), .joints = joints, .area = area_of(joints)};
  for (const Joint& j : joints) paths_.links.push_back({j.first, j.second, 0.0});
  return group;
}

ThermalSystem::Group ThermalSystem::add_outlets(const Joints& joints, Reservoir reservoir) {
  Group group{.first = paths_.outlets.size(), .joints = joints, .area = area_of(joints)};
  for (const Joint& j : joints) paths_.outlets.push_back({j.first, reservoir, 0.0});
  return group;
}

void ThermalSystem::set_links(Group& group, double film) {
  group.film = film;
  for (std::size_t k = 0; k < group.joints.size(); ++k)
    paths_.links[group.first + k].conductance =
        in_series(group.joints[k].half, film, group.joints[k].area);
}

void ThermalSystem::set_outlets(Group& group, double film) {
  group.film = film;
  for (std::size_t k = 0; k < group.joints.size(); ++k)
    paths_.outlets[group.first + k].conductance =
        in_series(group.joints[k].half, film, group.joints[k].area);
}

/// Within solids, and joints that no temperature changes.
void ThermalSystem::add_fixed() {
  const Mesh& mesh = layout_.mesh;
  for (const Touch& t : mesh.touches) {
    const Cell& a = mesh.cells[static_cast<std::size_t>(t.first)];
    const Cell& b = mesh.cells[static_cast<std::size_t>(t.second)];
    if (a.body != b.body || a.bearing != b.bearing) continue;
    paths_.links.push_back({t.first, t.second, conductance_of(t)});
  }
  for (const Joint& j : layout_.clamped) paths_.links.push_back({j.first, j.second, 1.0 / j.half});
  shoulders_ = add_links(layout_.shoulders);
  set_links(shoulders_, spindle_.seat.shoulder_conductance);
  collars_ = add_links(layout_.collars);
  set_links(collars_, spindle_.seat.collar_conductance);
  add_clamped_faces();
}

/// Faces conduct by the mean pressure of their clamping force.
void ThermalSystem::add_clamped_faces() {
  for (const ClampedFace& face : layout_.faces) {
    Group& group = faces_.emplace_back(add_links(face.joints));
    const auto conductivity = [&](int cell) {
      return layout_.mesh.cells[static_cast<std::size_t>(cell)].material.conductivity;
    };
    const Joint& one = face.joints.front();
    set_links(group, contact_conductance(face.force / group.area, 0.0, conductivity(one.first),
                                         conductivity(one.second)));
  }
}

/// Conductance of two faces with the surfaces of the seats under a pressure, or across a gap
/// [W/(m² K)].
double ThermalSystem::contact_conductance(double pressure, double gap, double first_conductivity,
                                          double second_conductivity) const {
  const model::Seat& seat = spindle_.seat;
  return seat_conductance({.roughness = seat.roughness,
                           .slope = seat.slope,
                           .hardness = seat.hardness,
                           .first_conductivity = first_conductivity,
                           .second_conductivity = second_conductivity},
                          pressure, gap);
}

/// A sleeve that nobody told of: around the housing between the sets and as far over their bearings
/// as it reaches, at the diameter of the coolant's channel, else in the middle of the wall. Without
/// a rear set to the end of the housing.
void ThermalSystem::add_sleeve(const effects::SpindleCondition& condition) {
  if (!(condition.sleeve_conductance > 0.0)) return;
  const BearingPlace& front = layout_.bearings[spindle_.front_positions.size() - 1];
  const bool two = !spindle_.rear_positions.empty();
  const double inner_from = front.position + 0.5 * front.width;
  const double inner_to =
      two ? spindle_.rear_positions.front() - 0.5 * front.width : layout_.housing_end;
  const double outer_to = two ? layout_.last_bearing_rear : layout_.housing_end;
  const double from = std::lerp(inner_from, layout_.first_bearing_front, condition.sleeve_reach);
  const double to = std::lerp(inner_to, outer_to, condition.sleeve_reach);
  double low = 1e9, high = 0.0;
  for (const Cell& c : layout_.mesh.cells)
    if (c.body == Body::housing) {
      low = std::min(low, c.inner_radius);
      high = std::max(high, c.outer_radius);
    }
  const double radius = spindle_.coolant ? 0.5 * spindle_.coolant->diameter : 0.5 * (low + high);
  double sum = 0.0;
  std::vector<std::pair<int, double>> at;  // cell and the length of it that is covered
  for (std::size_t k = 0; k < layout_.mesh.size(); ++k) {
    const Cell& c = layout_.mesh.cells[k];
    const double covered = std::min(c.end, to) - std::max(c.start, from);
    if (c.body != Body::housing || !(covered > 0.0) || radius < c.inner_radius ||
        radius >= c.outer_radius)
      continue;
    at.emplace_back(static_cast<int>(k), covered);
    sum += covered;
  }
  for (const auto& [cell, length] : at)
    paths_.outlets.push_back(
        {cell, Reservoir::coolant, condition.sleeve_conductance * length / sum});
}

void ThermalSystem::update(const Vector& temperatures, const Inputs& inputs) {
  update_seats(temperatures, inputs.speed);
  update_room(temperatures, inputs.speed);
  update_coolant(temperatures, inputs);
}

/// Conductance from the flange into the machine: the screwed joint and the path behind it in
/// series.
double ThermalSystem::flange_conductance() const {
  const model::Housing& h = spindle_.housing;
  return h.flange_joint ? in_series(1.0 / (joint_conductance() * h.flange_joint->area),
                                    h.flange_conductance, 1.0)
                        : h.flange_conductance;
}

/// Conductance of the screwed joint of the flange under its mean pressure [W/(m² K)]. The machine
/// has the conductivity of the housing.
double ThermalSystem::joint_conductance() const {
  const double conductivity =
      layout_.mesh.cells[static_cast<std::size_t>(layout_.flange.front().first)]
          .material.conductivity;
  return contact_conductance(spindle_.housing.flange_joint->pressure(), 0.0, conductivity,
                             conductivity);
}

void ThermalSystem::update_seats(const Vector& temperatures, double speed) {
  const model::Seat& seat = spindle_.seat;
  const model::SolidMaterial ring = model::steel_of_rings;
  const double mounted = kelvin(20);  // a seat knows differences alone, but for two materials
  for (std::size_t k = 0; k < layout_.bearings.size(); ++k) {
    const BearingPlace& b = layout_.bearings[k];
    const double inner = mean(b.inner_ring, temperatures) - mounted;
    const double outer = mean(b.outer_ring, temperatures) - mounted;
    const model::SolidMaterial& shaft = layout_.material(b.shaft_below);
    const model::SolidMaterial& housing = layout_.material(b.housing_above);
    const auto state = [&](const PressFit& fit, double first, double second) {
      return SeatState{.pressure = fit.pressure,
                       .gap = fit.gap,
                       .conductance = contact_conductance(fit.pressure, fit.gap, first, second)};
    };
    SeatsOfBearing& now = seats_[k];
    const PressFit on_shaft = press_fit(
        {2.0 * b.seat_bore, 2.0 * b.seat, shaft, mean(b.shaft_below, temperatures) - mounted},
        {2.0 * b.seat, 2.0 * b.inner_shoulder, ring, inner}, b.inner_interference, speed);
    now.inner = state(on_shaft, shaft.conductivity, ring.conductivity);
    set_links(inner_seats_[k], now.inner.conductance);
    now.outer = {.conductance = seat.outer_conductance};
    if (std::isnan(seat.outer_conductance)) {
      const PressFit in_housing =
          press_fit({2.0 * b.outer_shoulder, 2.0 * b.housing_seat, ring, outer},
                    {2.0 * b.housing_seat, 2.0 * b.housing_outer, housing,
                     mean(b.housing_above, temperatures) - mounted},
                    -b.outer_clearance, 0.0);
      now.outer = state(in_housing, ring.conductivity, housing.conductivity);
    }
    now.outer.conductance *= condition_.outer_seat_factor;
    set_links(outer_seats_[k], now.outer.conductance);
  }
}

void ThermalSystem::update_room(const Vector& temperatures, double speed) {
  const double room = paths_.temperature[static_cast<std::size_t>(Reservoir::air)];
  const model::Ambient& ambient = spindle_.ambient;
  const double free = condition_.convection_factor * ambient.convection_factor;
  const auto air_at = [&](double t) { return air_properties(0.5 * (t + room)); };
  if (housing_.area > 0.0) {
    double diameter = 0.0;
    for (const Joint& j : housing_.joints)
      diameter += j.area / housing_.area * 2.0 *
                  layout_.mesh.cells[static_cast<std::size_t>(j.first)].outer_radius;
    const double t = surface(housing_.joints, temperatures);
    set_outlets(housing_, free * free_cylinder(diameter, t - room, 0.5 * (t + room), air_at(t)) +
                              radiation(ambient.emissivity, t, room));
    const double face = surface(ends_.joints, temperatures);
    set_outlets(ends_, free * free_plate(diameter, face - room, 0.5 * (face + room), air_at(face)) +
                           radiation(ambient.emissivity, face, room));
  }
  const auto turning = [&](Group& group, double diameter) {
    if (!(group.area > 0.0)) return;
    const double t = surface(group.joints, temperatures);
    set_outlets(group, turning_shaft(ambient.rotating_convection, speed, diameter, t - room,
                                     0.5 * (t + room), air_at(t)) +
                           radiation(steel_emissivity, t, room));
  };
  turning(nose_, nose_diameter_);
  turning(rear_, rear_diameter_);
  if (gap_.joints.empty()) return;
  gap_.film = 0.0;
  const double inner = surface(gap_.joints, temperatures);
  double outer = 0.0;
  for (const Joint& j : gap_.joints) outer += j.area / gap_.area * temperatures[j.second];
  const FluidProperties air = air_properties(0.5 * (inner + outer));
  for (std::size_t k = 0; k < gap_.joints.size(); ++k) {
    const Joint& j = gap_.joints[k];
    const auto cell = [&](int c) -> const Cell& {
      return layout_.mesh.cells[static_cast<std::size_t>(c)];
    };
    const double low =
        spindle_.gap ? 0.5 * spindle_.gap->inner_diameter : cell(j.first).outer_radius;
    const double high =
        spindle_.gap ? 0.5 * spindle_.gap->outer_diameter : cell(j.second).inner_radius;
    const double film =
        annular_gap(low, high, speed, air) +
        radiation_of_gap(low, high, steel_emissivity, steel_emissivity, inner, outer);
    paths_.links[gap_.first + k].conductance = in_series(j.half, film, j.area);
    gap_.film += film * j.area / gap_.area;
  }
}

void ThermalSystem::update_coolant(const Vector& temperatures, const Inputs& inputs) {
  for (Circuit& c : circuits_) {
    const double mean_temperature = temperatures[c.node];
    set_links(c.walls, coolant_film(c.channel, mean_temperature, inputs.coolant_on));
    paths_.outlets[c.flow].conductance =
        coolant_conductance(c.channel, mean_temperature, inputs.coolant_on);
  }
}

double ThermalSystem::inlet(const Circuit& circuit, const Inputs& inputs) const {
  const bool first = &circuit == circuits_.data();
  if (!first && !std::isnan(circuit.channel.inlet_temperature))
    return circuit.channel.inlet_temperature;
  return std::isnan(inputs.coolant_inlet) ? spindle_.coolant->inlet_temperature
                                          : inputs.coolant_inlet;
}

/// Heat through a group from its cells to the reservoir, or to the second cells of its links [W].
double ThermalSystem::heat_through(const Group& group, const Vector& temperatures,
                                   bool outlets) const {
  double sum = 0.0;
  for (std::size_t k = group.first; k < group.first + group.joints.size(); ++k) {
    const double to = outlets ? paths_.outlets[k].outside(paths_.temperature)
                              : temperatures[paths_.links[k].second];
    sum += outlets ? paths_.outlets[k].conductance * (temperatures[paths_.outlets[k].node] - to)
                   : paths_.links[k].conductance * (temperatures[paths_.links[k].first] - to);
  }
  return sum;
}

std::vector<SurfaceState> ThermalSystem::surfaces(const Vector& temperatures) const {
  std::vector<SurfaceState> list;
  const auto add = [&](const std::string& name, const Group& group, double heat) {
    if (group.area > 0.0)
      list.push_back({.name = name, .area = group.area, .conductance = group.film, .heat = heat});
  };
  add("shoulders", shoulders_, unset);
  add("collars", collars_, unset);
  const std::vector<std::string> bearings = model::bearing_names(
      spindle_.front_positions.size(), spindle_.rear_positions.size(), spindle_.rollers);
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const ClampedFace& face = layout_.faces[k];
    add(fmt::format("{}_{}_{}", bearings[static_cast<std::size_t>(face.bearing)],
                    face.inner ? "inner" : "outer", face.rear ? "rear" : "front"),
        faces_[k], heat_through(faces_[k], temperatures, false));
    list.back().pressure = face.force / faces_[k].area;
  }
  add("flange", flange_, heat_through(flange_, temperatures, true));
  if (flange_.area > 0.0 && spindle_.housing.flange_joint) {
    const model::ScrewedJoint& joint = *spindle_.housing.flange_joint;
    list.back().area = joint.area;
    list.back().conductance = joint_conductance();
    list.back().pressure = joint.pressure();
  }
  add("gap", gap_, heat_through(gap_, temperatures, false));
  add("nose", nose_, heat_through(nose_, temperatures, true));
  add("shaft_rear", rear_, heat_through(rear_, temperatures, true));
  add("housing", housing_, heat_through(housing_, temperatures, true));
  add("housing_ends", ends_, heat_through(ends_, temperatures, true));
  for (std::size_t k = 0; k < circuits_.size(); ++k)
    add(k == 0 ? "coolant" : spindle_.circuits[k - 1].name, circuits_[k].walls,
        heat_through(circuits_[k].walls, temperatures, false));
  return list;
}

CylinderHeat ThermalSystem::through_cylinders(const Vector& temperatures) const {
  const auto cells = static_cast<Eigen::Index>(layout_.mesh.size());
  CylinderHeat heat{Vector::Zero(cells), Vector::Zero(cells)};
  for (const HeatPaths::Link& link : paths_.links) {
    if (link.first >= cells || link.second >= cells) continue;
    const Cell& a = layout_.mesh.cells[static_cast<std::size_t>(link.first)];
    const Cell& b = layout_.mesh.cells[static_cast<std::size_t>(link.second)];
    if (a.column != b.column) continue;
    const int low = a.row < b.row ? link.first : link.second;
    const int high = a.row < b.row ? link.second : link.first;
    const double outward = link.conductance * (temperatures[low] - temperatures[high]);
    heat.outer[low] += outward;
    heat.inner[high] -= outward;
  }
  const double room = paths_.temperature[static_cast<std::size_t>(Reservoir::air)];
  for (const Group* const group : {&nose_, &rear_})
    for (std::size_t k = 0; k < group->joints.size(); ++k) {
      const Joint& j = group->joints[k];
      if (!j.axial)
        heat.outer[j.first] +=
            paths_.outlets[group->first + k].conductance * (temperatures[j.first] - room);
    }
  return heat;
}

double ThermalSystem::ambient(const Inputs& inputs) const {
  return std::isnan(inputs.ambient_temperature) ? spindle_.ambient.temperature
                                                : inputs.ambient_temperature;
}

void ThermalSystem::set_inputs(const Inputs& inputs, double machine_rise) {
  const double room = ambient(inputs);
  double machine = inputs.machine_temperature;
  if (std::isnan(machine)) machine = spindle_.ambient.machine_temperature;
  if (std::isnan(machine)) machine = room;
  double supply = inputs.coolant_inlet;
  if (std::isnan(supply)) supply = spindle_.coolant ? spindle_.coolant->inlet_temperature : room;
  paths_.temperature = {room, machine + machine_rise, supply};
  for (const Circuit& c : circuits_) paths_.outlets[c.flow].above = inlet(c, inputs) - supply;

  paths_.source.setZero();
  driven_heat_ = 0.0;
  const double ratio = inputs.speed / (10000.0 * rpm);
  double motor = std::isnan(inputs.motor_heat) ? 0.0 : inputs.motor_heat;
  if (std::isnan(inputs.motor_heat) && spindle_.motor)
    motor = heat_of(*spindle_.motor, spindle_, inputs);
  add_source(motor_,
             motor + condition_.motor_heat * std::pow(ratio, condition_.motor_heat_exponent));
  const double drive = spindle_.drive ? heat_of(*spindle_.drive, spindle_, inputs) : 0.0;
  add_source(drive_,
             drive + condition_.drive_heat * std::pow(ratio, condition_.drive_heat_exponent));
  add_source(seal_, condition_.seal_heat * ratio);
  add_source(front_bearings_, condition_.front_bearing_heat * ratio);
  add_source(rear_bearings_, condition_.rear_bearing_heat * ratio);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    source_heat_[k] = heat_of(spindle_.heat[k], spindle_, inputs);
    add_source(sources_[k], source_heat_[k]);
  }
}

ThermalSystem::HeatedCells ThermalSystem::cells_of(const model::HeatSource& source) const {
  using Place = model::HeatSource::Place;
  const Layout& l = layout_;
  const bool spanned = !std::isnan(source.position) && !std::isnan(source.length);
  const auto span = [&](double from, double to) {
    return spanned ? std::pair(source.position - 0.5 * source.length,
                               source.position + 0.5 * source.length)
                   : std::pair(from, to);
  };
  switch (source.place) {
    case Place::motor: {
      const BearingPlace& front = l.bearings[spindle_.front_positions.size() - 1];
      const bool two = !spindle_.rear_positions.empty();
      const double end = two ? spindle_.rear_positions.front() - 0.5 * front.width : l.housing_end;
      const auto [low, high] = span(front.position + 0.5 * front.width, end);
      return {l.source(Body::shaft, low, high), l.source(Body::housing, low, high),
              source.rotor_share};
    }
    case Place::pulley: {
      constexpr double rear_end = 1e3;  // beyond every shaft [m]
      const auto [low, high] = span(l.last_bearing_rear, rear_end);
      return {l.source(Body::shaft, low, high), {}};
    }
    case Place::seal: {
      const auto [low, high] = span(l.housing_start, l.first_bearing_front);
      return {l.source(Body::shaft, low, high), {}};
    }
    case Place::bearing: {
      const BearingPlace& b = l.bearings.at(source.bearing);
      return {by_area(b.inner_raceway), by_area(b.outer_raceway), source.rotor_share};
    }
    case Place::shaft:
    case Place::housing:
      break;
  }
  const auto [low, high] = span(unset, unset);
  return {l.source(source.place == Place::shaft ? Body::shaft : Body::housing, low, high,
                   source.radius),
          {}};
}

void ThermalSystem::add_source(const HeatedCells& cells, double heat) {
  if (heat == 0.0) return;
  const auto add = [&](const Shares& shares, double part) {
    for (const Share& s : shares) paths_.source[s.cell] += s.share * part;
    driven_heat_ += part;
  };
  add(cells.first, cells.share * heat);
  if (!cells.second.empty()) add(cells.second, (1.0 - cells.share) * heat);
}

}  // namespace raceway::spindle
