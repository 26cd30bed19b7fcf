#include "cli/spindle_state_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/text_table.h"
#include "record/units.h"
#include "shaft/shaft_balance.h"

namespace raceway::cli {
namespace {

std::string in_celsius(double kelvins) { return number(celsius(kelvins)); }

void print_temperatures(const model::Model& model, const spindle::Moment& m) {
  if (!m.bearings.empty()) {
    const bool rollers = !model.spindle->rollers.empty();
    const bool across = rollers || std::any_of(m.bearings.begin(), m.bearings.end(),
                                               [](const auto& b) { return b.radial_force > 0.0; });
    std::vector<TextTable::Column> columns{
        {"bearing", "", true}, {"inner ring", "C"}, {"outer ring", "C"}, {"force", "N"}};
    if (across) columns.push_back({"radial", "N"});
    if (rollers) columns.push_back({"clearance", "um"});
    columns.push_back({"friction", "W"});
    TextTable table(columns);
    for (std::size_t k = 0; k < m.bearings.size(); ++k) {
      const spindle::BearingState& b = m.bearings[k];
      std::vector<std::string> row{results::bearing_label(model, k),
                                   in_celsius(b.inner_ring_temperature),
                                   in_celsius(b.outer_ring_temperature), number(b.force)};
      if (across) row.push_back(number(b.radial_force));
      if (rollers) row.push_back(number(b.clearance / um));
      row.push_back(friction_words(b.power, b.power_band));
      table.add(std::move(row));
    }
    fmt::print("{}\n", table.text(terminal_width()));
  }
  if (m.sensors.empty()) return;
  TextTable table({{model.spindle->network ? "node" : "sensor", "", true}, {"temperature", "C"}});
  for (std::size_t k = 0; k < m.sensors.size(); ++k)
    table.add({model.spindle->sensors[k].name, in_celsius(m.sensors[k])});
  fmt::print("{}\n", table.text(terminal_width()));
}

void print_seats(const model::Model& model, const std::vector<spindle::SeatsOfBearing>& seats) {
  if (seats.empty()) return;
  TextTable table({{"seat", "", true},
                   {"on shaft", "MPa"},
                   {"conducts", "W/(m2 K)"},
                   {"in housing", "MPa"},
                   {"conducts", "W/(m2 K)"}});
  const auto pressure = [](const spindle::SeatState& seat) {
    return seat.pressure > 0.0    ? number(seat.pressure / MPa, 3)
           : seat.pressure == 0.0 ? std::string("loose")
                                  : number(seat.pressure);
  };
  for (std::size_t k = 0; k < seats.size(); ++k)
    table.add({results::bearing_label(model, k), pressure(seats[k].inner),
               number(seats[k].inner.conductance, 3), pressure(seats[k].outer),
               number(seats[k].outer.conductance, 3)});
  fmt::print("{}\n", table.text(terminal_width()));
}

/// Prints joints and surfaces with area, heat transfer coefficient, pressure and heat.
void print_surfaces(const std::vector<spindle::SurfaceState>& surfaces) {
  if (surfaces.empty()) return;
  TextTable table({{"surface", "", true},
                   {"area", "mm2"},
                   {"conducts", "W/(m2 K)"},
                   {"pressure", "MPa"},
                   {"heat", "W"}});
  for (const spindle::SurfaceState& s : surfaces)
    table.add({s.name, number(s.area / (mm * mm), 3), number(s.conductance, 3),
               number(s.pressure / MPa, 3), number(s.heat, 3)});
  fmt::print("{}\n", table.text(terminal_width()));
}

/// Prints the largest von Mises stress of each part, and the components of the largest of all.
void print_stresses(const model::Model& model, const std::vector<spindle::SectionStress>& all) {
  if (all.empty()) return;
  using Part = spindle::SectionStress::Part;
  const auto largest_of = [&](Part part, int bearing) {
    std::vector<spindle::SectionStress> some;
    for (const spindle::SectionStress& s : all)
      if (s.part == part && s.bearing == bearing) some.push_back(s);
    const spindle::SectionStress* const most = results::largest_stress(some);
    return most ? number(most->largest().von_mises() / MPa, 3) : std::string("-");
  };
  TextTable table(
      {{"stress", "", true}, {"shaft", "MPa"}, {"inner ring", "MPa"}, {"outer ring", "MPa"}});
  int bearings = 0;
  for (const spindle::SectionStress& s : all) bearings = std::max(bearings, s.bearing + 1);
  for (int k = 0; k < bearings; ++k)
    table.add({results::bearing_label(model, static_cast<std::size_t>(k)),
               largest_of(Part::shaft, k), largest_of(Part::inner_ring, k),
               largest_of(Part::outer_ring, k)});
  table.add({"elsewhere", largest_of(Part::shaft, -1), "-", "-"});
  const spindle::SectionStress& most = *results::largest_stress(all);
  const spindle::Stress& s = most.largest();
  const std::string part = most.part == Part::shaft        ? "shaft"
                           : most.part == Part::inner_ring ? "inner ring"
                                                           : "outer ring";
  fmt::print(
      "{}\nlargest stress: {} MPa von Mises in the {} at {:.4g} mm, on the diameter {:.4g} mm: "
      "axial "
      "{}, hoop {}, radial {} MPa\n",
      table.text(terminal_width()), number(s.von_mises() / MPa, 3), part,
      0.5 * (most.start + most.end) / mm, 2.0 * s.radius / mm, number(s.axial / MPa, 3),
      number(s.hoop / MPa, 3), number(s.radial / MPa, 3));
}

void print_heat(const spindle::HeatBalance& heat) {
  fmt::print(
      "heat: {} W friction and {} W of drives; {} W to the coolant, {} W to the air, {} W to the "
      "machine; balance error {:.2g} W\n",
      friction_words(heat.friction, heat.friction_band), number(heat.drive), number(heat.coolant),
      number(heat.air), number(heat.machine), heat.stored);
}

void print_coolant(const spindle::ChannelFlow& flow) {
  fmt::print(
      "coolant: velocity {} m/s, Reynolds number {}, heat transfer coefficient {} W/(m2 K), "
      "pressure drop {} bar in the channel{}\n",
      number(flow.velocity, 3), number(flow.reynolds, 3), number(flow.film, 3),
      number(flow.pressure_drop / spindle::bar, 3),
      flow.throttle_drop > 0.0
          ? fmt::format(", {} bar at the throttle", number(flow.throttle_drop / spindle::bar, 3))
          : std::string());
}

/// Prints all circuits of a spindle with more than one.
void print_circuits(const model::Model& model, const results::SteadyState& s) {
  TextTable table({{"circuit", "", true},
                   {"inlet", "C"},
                   {"outlet", "C"},
                   {"heat", "W"},
                   {"velocity", "m/s"},
                   {"film", "W/(m2 K)"},
                   {"channel", "bar"},
                   {"throttle", "bar"}});
  for (std::size_t k = 0; k < s.channels.size(); ++k) {
    const spindle::CircuitState& now = s.moment.circuits[k];
    const spindle::ChannelFlow flow = s.channels[k].value_or(spindle::ChannelFlow{
        .film = model.spindle->channels()[k].stagnant, .throttle_drop = unset});
    table.add({results::circuit_name(model, k), number(celsius(now.inlet)),
               number(celsius(now.outlet)), number(now.heat), number(flow.velocity, 3),
               number(flow.film, 3), number(flow.pressure_drop / spindle::bar, 3),
               number(flow.throttle_drop / spindle::bar, 3)});
  }
  fmt::print("\n{}\n", table.text(terminal_width()));
}

}  // namespace

std::string friction_words(double power, double band) {
  return band > 0.0 ? fmt::format("{} +- {}", number(power), number(band, 2)) : number(power);
}

void print_steady_state(const model::Model& model, const results::SteadyState& s) {
  fmt::print("{} at {:.6g} rpm, coolant {}: {}\n\n", model.spindle->name, s.inputs.speed / rpm,
             !model.spindle->coolant ? "none"
             : s.inputs.coolant_on   ? "on"
                                     : "off",
             spindle::words(s.report.status));
  if (!s.report.converged()) return;
  print_temperatures(model, s.moment);
  print_seats(model, s.seats);
  print_surfaces(s.surfaces);
  print_stresses(model, s.stress);
  print_heat(s.moment.heat);
  if (s.channels.size() > 1)
    print_circuits(model, s);
  else if (!s.channels.empty() && s.channels.front())
    print_coolant(*s.channels.front());
  if (model.spindle->network) return;
  const spindle::Moment& m = s.moment;
  fmt::print("forces of the bearing sets: front {} N, rear {} N; preload as mounted {:.4g} N\n",
             number(m.front_force), number(m.rear_force),
             shaft::mounted_arrangement(model).preload());
  fmt::print("axial stiffness of the warm bearing sets: {} N/um\n",
             number(s.axial_stiffness / N_per_um));
  fmt::print(
      "displacement of the nose relative to the flange: {} um, of which the bearing sets cause {} "
      "um\n",
      number(m.displacement / um), number(m.kinematic_displacement / um));
  fmt::print("displacement of the rear end of the shaft relative to the flange: {} um\n",
             number(s.shaft.back().displacement / um));
}

}  // namespace raceway::cli
