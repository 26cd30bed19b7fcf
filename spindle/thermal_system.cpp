#include "spindle/thermal_system.h"

#include <algorithm>
#include <array>
#include <cmath>

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
  const bool cooled = spindle_.coolant.has_value();
  paths_.capacity.setZero(n + (cooled ? 1 : 0));
  for (Eigen::Index k = 0; k < n; ++k)
    paths_.capacity[k] = layout_.mesh.cells[static_cast<std::size_t>(k)].heat_capacity();
  paths_.source.setZero(paths_.size());
  if (cooled) {
    const model::Coolant& c = *spindle_.coolant;
    const FluidProperties fluid = fluid_properties(c.fluid, c.inlet_temperature);
    coolant_ = static_cast<int>(n);
    paths_.capacity[n] = c.channel_width * c.channel_depth * layout_.helix_length * fluid.density *
                         fluid.heat_capacity;
  }
  add_fixed();
  for (const BearingPlace& b : layout_.bearings) {
    inner_seats_.push_back(add_links(b.inner_seat));
    outer_seats_.push_back(add_links(b.outer_seat));
  }
  gap_ = add_links(layout_.gap);
  housing_ = add_outlets(layout_.housing_cylinder, Reservoir::air);
  ends_ = add_outlets(layout_.housing_ends, Reservoir::air);
  nose_ = add_outlets(layout_.nose, Reservoir::air);
  rear_ = add_outlets(layout_.rear, Reservoir::air);
  const Group flange = add_outlets(layout_.flange, Reservoir::machine);
  if (flange.area > 0.0)
    set_outlets(flange, condition_.flange_conductance_factor * spindle_.housing.flange_conductance /
                            flange.area);
  if (cooled) {
    Joints walls = layout_.coolant_walls;
    for (Joint& j : walls) j.second = coolant_;
    coolant_walls_ = add_links(walls);
    coolant_flow_ = paths_.outlets.size();
    paths_.outlets.push_back({coolant_, Reservoir::coolant, 0.0});
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

void ThermalSystem::set_links(const Group& group, double film) {
  for (std::size_t k = 0; k < group.joints.size(); ++k)
    paths_.links[group.first + k].conductance =
        in_series(group.joints[k].half, film, group.joints[k].area);
}

void ThermalSystem::set_outlets(const Group& group, double film) {
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
  set_links(add_links(layout_.shoulders), spindle_.seat.shoulder_conductance);
  set_links(add_links(layout_.collars), spindle_.seat.collar_conductance);
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
  if (coolant_ >= 0) update_coolant(temperatures, inputs);
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
    const auto film = [&](const PressFit& fit, double first, double second) {
      return seat_conductance({.roughness = seat.roughness,
                               .slope = seat.slope,
                               .hardness = seat.hardness,
                               .first_conductivity = first,
                               .second_conductivity = second},
                              fit.pressure, fit.gap);
    };
    const PressFit on_shaft = press_fit(
        {2.0 * b.seat_bore, 2.0 * b.seat, shaft, mean(b.shaft_below, temperatures) - mounted},
        {2.0 * b.seat, 2.0 * b.inner_shoulder, ring, inner}, b.inner_interference, speed);
    set_links(inner_seats_[k], film(on_shaft, shaft.conductivity, ring.conductivity));
    double conductance = seat.outer_conductance;
    if (std::isnan(conductance)) {
      const PressFit in_housing =
          press_fit({2.0 * b.outer_shoulder, 2.0 * b.housing_seat, ring, outer},
                    {2.0 * b.housing_seat, 2.0 * b.housing_outer, housing,
                     mean(b.housing_above, temperatures) - mounted},
                    -b.outer_clearance, 0.0);
      conductance = film(in_housing, ring.conductivity, housing.conductivity);
    }
    set_links(outer_seats_[k], condition_.outer_seat_factor * conductance);
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
  const auto turning = [&](const Group& group, double diameter) {
    if (!(group.area > 0.0)) return;
    const double t = surface(group.joints, temperatures);
    set_outlets(group, turning_shaft(ambient.rotating_convection, speed, diameter, t - room,
                                     0.5 * (t + room), air_at(t)) +
                           radiation(steel_emissivity, t, room));
  };
  turning(nose_, nose_diameter_);
  turning(rear_, rear_diameter_);
  if (gap_.joints.empty()) return;
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
  }
}

void ThermalSystem::update_coolant(const Vector& temperatures, const Inputs& inputs) {
  const model::Coolant& c = *spindle_.coolant;
  const FluidProperties fluid = fluid_properties(c.fluid, temperatures[coolant_]);
  set_links(coolant_walls_, coolant_film(c, temperatures[coolant_], inputs.coolant_on));
  // The node is the mean of inlet and outlet.
  paths_.outlets[coolant_flow_].conductance =
      inputs.coolant_on ? 2.0 * c.flow * fluid.density * fluid.heat_capacity : 0.0;
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
  double inlet = inputs.coolant_inlet;
  if (std::isnan(inlet)) inlet = spindle_.coolant ? spindle_.coolant->inlet_temperature : room;
  paths_.temperature = {room, machine + machine_rise, inlet};

  paths_.source.setZero();
  driven_heat_ = 0.0;
  const Layout& l = layout_;
  const std::array<double, 3> names{inputs.speed / rpm, inputs.axial_load, inputs.radial_load};
  const auto heat_of = [&](const model::HeatSource& source) {
    std::vector<double> used;
    for (const std::size_t k : source.heat->used()) used.push_back(names[k]);
    return (*source.heat)(used);
  };
  const auto place = [&](const std::optional<model::HeatSource>& source, double from, double to) {
    if (!source || std::isnan(source->position) || std::isnan(source->length))
      return std::pair(from, to);
    return std::pair(source->position - 0.5 * source->length,
                     source->position + 0.5 * source->length);
  };
  const double ratio = inputs.speed / (10000.0 * rpm);
  constexpr double rear_end = 1e3;  // beyond every shaft [m]
  double motor = std::isnan(inputs.motor_heat) ? 0.0 : inputs.motor_heat;
  if (std::isnan(inputs.motor_heat) && spindle_.motor) motor = heat_of(*spindle_.motor);
  motor += condition_.motor_heat * std::pow(ratio, condition_.motor_heat_exponent);
  if (motor != 0.0) {
    const BearingPlace& front = l.bearings[spindle_.front_positions.size() - 1];
    const bool two = !spindle_.rear_positions.empty();
    const double from = front.position + 0.5 * front.width;
    const double to = two ? spindle_.rear_positions.front() - 0.5 * front.width : l.housing_end;
    const auto [low, high] = place(spindle_.motor, from, to);
    const double share = spindle_.motor ? spindle_.motor->rotor_share : 0.5;
    add_source(l.source(Body::shaft, low, high), share * motor);
    add_source(l.source(Body::housing, low, high), (1.0 - share) * motor);
  }
  double drive = spindle_.drive ? heat_of(*spindle_.drive) : 0.0;
  drive += condition_.drive_heat * std::pow(ratio, condition_.drive_heat_exponent);
  if (drive != 0.0) {
    const auto [low, high] = place(spindle_.drive, l.last_bearing_rear, rear_end);
    add_source(l.source(Body::shaft, low, high), drive);
  }
  if (condition_.seal_heat != 0.0)
    add_source(l.source(Body::shaft, l.housing_start, l.first_bearing_front),
               condition_.seal_heat * ratio);
}

void ThermalSystem::add_source(const Shares& shares, double heat) {
  for (const Share& s : shares) paths_.source[s.cell] += s.share * heat;
  driven_heat_ += heat;
}

}  // namespace raceway::spindle
