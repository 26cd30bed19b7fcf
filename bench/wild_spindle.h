#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/robustness_domain.h"
#include "effects/spindle_condition.h"
#include "spindle/spindle.h"

/// Random spindles of likely and unlikely shapes. The simulation must return a correct status for
/// each of them.
namespace raceway::robustness {

struct WildSpindle {
  model::Model model;
  effects::SpindleCondition condition;
  spindle::Inputs inputs;
  /// Ten minutes at one speed from the cold state, one minute with the coolant switched on or off,
  /// then another speed.
  std::vector<spindle::ProfileRow> programme;
};

/// Draws random parts of a spindle.
class WildParts {
 public:
  WildParts(std::uint64_t seed, std::uint64_t index)
      : state_(seed * 0x9e3779b97f4a7c15ULL + index * 0xd1342543de82ef95ULL) {}

  WildSpindle draw() {
    draw_sizes();
    const auto bearing = any_bearing();
    WildSpindle w{.model = {.name = "wild",
                            .bearing = *bearing,
                            .lubricant = any_lubricant(),
                            .law_values = {spread(0.1, 8.0), spread(1e-5, 2e-3), 0.33},
                            .effects = {},
                            .solver = {},
                            .rig = {},
                            .free = {}},
                  .condition = {},
                  .inputs = {},
                  .programme = {}};
    w.model.f1_load = one_in(2) ? friction::F1Load::F_b : w.model.f1_load;
    w.model.shaft = model::Shaft{.arrangement = bearing::Arrangement(any_sets(bearing))};
    w.model.spindle = model::Spindle{};
    place_bearings(*w.model.spindle);
    add_shaft(*w.model.spindle);
    add_housing(*w.model.spindle);
    add_surroundings(*w.model.spindle);
    if (one_in(4)) w.condition = any_condition();
    add_programme(w);
    return w;
  }

 private:
  double uniform(double low, double high) { return uniform_number(state_, low, high); }
  double spread(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  bool one_in(double n) { return uniform(0.0, n) < 1.0; }
  std::size_t count(int most) {
    return static_cast<std::size_t>(std::min(uniform(0.0, most), most - 1e-9)) + 1;
  }

  /// Draws the dimensions of a bearing with a bore of 15 to 150 mm.
  void draw_sizes() {
    bore_ = spread(15.0, 150.0) * mm;
    ball_ = bore_ * uniform(0.1, 0.25);
    pitch_ = bore_ + ball_ * uniform(1.6, 2.4);
    width_ = ball_ * uniform(1.2, 1.8);
    balls_ = std::max(3, static_cast<int>(uniform(0.4, 0.95) * pi * pitch_ / ball_));
    rating_ = 12e6 * balls_ * ball_ * ball_;
  }

  /// Returns a bearing with a contact angle of 5 to 45 degrees, conformities of 0.505 to 0.58, and
  /// steel or ceramic balls.
  std::shared_ptr<const bearing::Bearing> any_bearing() {
    return std::make_shared<const bearing::Bearing>(
        bearing::BearingGeometry{.ball_count = balls_,
                                 .ball_diameter = ball_,
                                 .pitch_diameter = pitch_,
                                 .contact_angle = uniform(5.0, 45.0) * degree,
                                 .inner_conformity = uniform(0.505, 0.58),
                                 .outer_conformity = uniform(0.505, 0.58),
                                 .bore = bore_,
                                 .outer_diameter = 2.0 * pitch_ - bore_,
                                 .static_load_rating = rating_},
        one_in(3) ? bearing::silicon_nitride() : bearing::steel(), bearing::steel());
  }

  friction::Lubricant any_lubricant() {
    const double at_40 = spread(3.0, 300.0);
    return {at_40 * mm2_per_s, std::pow(at_40, uniform(0.5, 0.75)) * mm2_per_s};
  }

  /// Returns an arrangement: tandem in an eighth of the cases, otherwise O or X; rigid or with
  /// springs; one to four bearings on each side; a preload force of 0.0005 to 0.1 C0, or an offset.
  bearing::ArrangementDesign any_sets(const std::shared_ptr<const bearing::Bearing>& first) {
    bearing::ArrangementDesign d;
    d.layout = one_in(8)   ? bearing::Layout::tandem
               : one_in(2) ? bearing::Layout::back_to_back
                           : bearing::Layout::face_to_face;
    const auto second = one_in(2) ? first : any_bearing();
    front_ = count(4);
    rear_ = d.layout == bearing::Layout::tandem ? 0 : count(4);
    d.front.assign(front_, {first});
    d.rear.assign(rear_, {second});
    for (auto* set : {&d.front, &d.rear})
      for (bearing::MountedBearing& b : *set) b.offset = one_in(2) ? uniform(-2.0, 2.0) * um : 0.0;
    if (rear_ == 0 || one_in(3)) {
      d.mounting = bearing::Mounting::spring;
      d.spring_rate = one_in(2) ? 0.0 : spread(0.1, 100.0) * N_per_um;
    } else if (one_in(2)) {
      d.shaft_stiffness = spread(50.0, 5000.0) * N_per_um;
      d.housing_stiffness = spread(50.0, 5000.0) * N_per_um;
    }
    preload_ = rating_ * spread(0.0005, 0.1);
    d.preload = bearing::PreloadForce{preload_};
    if (d.mounting == bearing::Mounting::rigid && one_in(6))
      d.preload = bearing::PreloadOffset{uniform(1.0, 30.0) * um};
    return d;
  }

  void place_bearings(model::Spindle& s) {
    s.bearing_width = width_;
    s.inner_ring_shoulder = pitch_ - ball_ * uniform(0.5, 0.9);
    s.outer_ring_shoulder = pitch_ + ball_ * uniform(0.5, 0.9);
    seats_start_ = uniform(0.2, 4.0) * width_;
    double face = seats_start_;
    const auto set = [&](std::size_t bearings, std::vector<double>& positions) {
      const double apart = one_in(2) ? 0.0 : uniform(0.05, 1.5) * width_;
      for (std::size_t k = 0; k < bearings; ++k) {
        positions.push_back(face + 0.5 * width_);
        face += width_ + (k + 1 < bearings ? apart : 0.0);
      }
    };
    set(front_, s.front_positions);
    front_end_ = rear_start_ = face;
    if (rear_ > 0) {
      rear_start_ = face += spread(0.1, 8.0) * bore_;
      set(rear_, s.rear_positions);
    }
    seats_end_ = face;
    s.lubricant_conductance = one_in(4) ? 0.0 : spread(0.05, 10.0);
    s.inner_heat_share = one_in(2) ? unset : uniform(0.0, 1.0);
    s.preload_feedback = !one_in(4);
  }

  /// Adds shaft segments of random sizes in front of, between and behind the seats.
  void add_shaft(model::Spindle& s) {
    const bool hollow = !one_in(4);
    const double share = uniform(0.1, 0.85);
    const auto piece = [&](double length, double diameter) {
      s.shaft.segments.push_back(
          {.length = length,
           .diameter = diameter,
           .bore = hollow ? share * std::min(bore_, diameter) : 0.0,
           .material = one_in(8) ? model::iron_of_housings : model::steel_of_shafts});
    };
    const auto pieces = [&](double length, int most, double low, double high) {
      const std::size_t n = count(most);
      for (std::size_t k = 0; k < n; ++k)
        piece(length / static_cast<double>(n), bore_ * uniform(low, high));
    };
    pieces(seats_start_, 2, 0.7, 1.15);
    piece(front_end_ - seats_start_, bore_);
    if (rear_ > 0) {
      pieces(rear_start_ - front_end_, 4, 0.6, 1.15);
      piece(seats_end_ - rear_start_, bore_);
    }
    if (!one_in(5)) pieces(bore_ * spread(0.1, 3.0), 3, 0.4, 1.0);
  }

  void add_housing(model::Spindle& s) {
    const double bored = 2.0 * pitch_ - bore_, thinnest = bored * uniform(1.1, 2.0);
    s.housing.start = one_in(3) ? seats_start_ : uniform(0.0, seats_start_);
    const double end = seats_end_ + (one_in(3) ? 0.0 : uniform(0.0, 3.0) * width_);
    const std::size_t n = count(3);
    const double length = end - s.housing.start;
    for (std::size_t k = 0; k < n; ++k)
      s.housing.segments.push_back(
          {.length = length / static_cast<double>(n),
           .diameter = k == 0 ? thinnest : thinnest * uniform(1.0, 1.6),
           .bore = unset,
           .material = one_in(3) ? model::steel_of_shafts : model::iron_of_housings});
    s.housing.flange = uniform(s.housing.start, end);
    s.housing.flange_length = uniform(0.1, 3.0) * width_;
    s.housing.flange_conductance = one_in(6) ? 0.0 : spread(0.1, 100.0);
    if (one_in(2)) return;
    const double wall = 0.5 * (thinnest - bored), depth = wall * uniform(0.05, 0.6);
    const double width = depth * spread(0.5, 4.0);
    s.coolant = model::Coolant{.fluid = one_in(3) ? model::Fluid::oil : model::Fluid::water,
                               .flow = one_in(10) ? 0.0 : spread(0.01, 60.0) * 1e-3 / 60.0,
                               .inlet_temperature = kelvin(uniform(5.0, 40.0)),
                               .diameter = bored + depth + 2.0 * (wall - depth) * uniform(0.1, 0.9),
                               .channel_width = width,
                               .channel_depth = depth,
                               .pitch = width * uniform(1.05, 4.0),
                               .start = s.housing.start + length * uniform(-0.2, 0.4),
                               .end = s.housing.start + length * uniform(0.6, 1.2),
                               .stagnant = one_in(5) ? 0.0 : spread(1.0, 100.0)};
  }

  /// Draws seats from loose to tight, and heat transfer from zero to many times the usual value.
  void add_surroundings(model::Spindle& s) {
    s.cells = model::Cells::coarse;
    s.seat = {.inner_interference = uniform(-10.0, 40.0) * um,
              .outer_clearance = uniform(-20.0, 50.0) * um,
              .roughness = spread(0.05, 10.0) * um,
              .slope = uniform(0.05, 0.3),
              .hardness = uniform(1.0, 8.0) * 1e9,
              .shoulder_conductance = one_in(6) ? 0.0 : spread(100.0, 1e5),
              .collar_conductance = one_in(6) ? 0.0 : spread(100.0, 1e5),
              .outer_conductance = !one_in(4)  ? unset
                                   : one_in(4) ? 0.0
                                               : spread(1.0, 1e5)};
    s.ambient = {.temperature = kelvin(uniform(-10.0, 45.0)),
                 .machine_temperature = one_in(2) ? unset : kelvin(uniform(-10.0, 60.0)),
                 .emissivity = one_in(5) ? 0.0 : uniform(0.0, 1.0),
                 .convection_factor = one_in(5) ? 0.0 : spread(0.1, 10.0),
                 .rotating_convection = one_in(3)   ? model::RotatingConvection::becker
                                        : one_in(2) ? model::RotatingConvection::kendoush
                                                    : model::RotatingConvection::anderson_saunders};
  }

  effects::SpindleCondition any_condition() {
    return {.outer_seat_factor = one_in(4) ? 0.0 : spread(0.01, 10.0),
            .convection_factor = spread(0.1, 10.0),
            .bearing_conductance_factor = spread(0.05, 20.0),
            .flange_conductance_factor = spread(0.05, 20.0),
            .motor_heat = one_in(2) ? 0.0 : spread(1.0, 1000.0),
            .drive_heat = one_in(2) ? 0.0 : spread(1.0, 500.0),
            .seal_heat = one_in(2) ? 0.0 : spread(1.0, 200.0),
            .sleeve_conductance = one_in(2) ? 0.0 : spread(0.1, 200.0),
            .structure_rise = uniform(-10.0, 10.0),
            .structure_time = spread(60.0, 1e5),
            .other_preload_feedback = uniform(0.0, 1.0)};
  }

  /// Adds the programme. A speed has n d_m from 1e4 to 2.5e6 rpm mm, or is zero in a tenth of the
  /// cases. A third of the cases has an axial load of up to four preloads.
  void add_programme(WildSpindle& w) {
    const auto speed = [&] { return one_in(10) ? 0.0 : spread(1e4, 2.5e6) / (pitch_ / mm) * rpm; };
    w.inputs.speed = speed();
    if (one_in(3)) w.inputs.axial_load = uniform(-4.0, 4.0) * preload_;
    if (one_in(3)) w.inputs.motor_heat = spread(1.0, 1500.0);
    w.inputs.coolant_on = !one_in(4);
    spindle::Inputs switched = w.inputs, last = w.inputs;
    switched.coolant_on = !switched.coolant_on;
    last.speed = speed();
    w.programme = {{.time = 600.0, .inputs = w.inputs},
                   {.time = 660.0, .inputs = switched},
                   {.time = 1800.0, .inputs = last}};
  }

  std::uint64_t state_;
  double bore_ = unset, ball_ = unset, pitch_ = unset, width_ = unset, rating_ = unset;
  double preload_ = unset, seats_start_ = unset, front_end_ = unset, rear_start_ = unset;
  double seats_end_ = unset;
  int balls_ = 0;
  std::size_t front_ = 0, rear_ = 0;
};

/// Returns spindle number `index` of a seed; equal on every machine.
inline WildSpindle make_wild_spindle(std::uint64_t seed, std::uint64_t index) {
  return WildParts(seed, index).draw();
}

/// Returns true if all numbers of a moment are finite and the moment has bearings.
inline bool finite(const spindle::Moment& m) {
  const auto all = [](std::initializer_list<double> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  bool good = all({m.displacement, m.kinematic_displacement, m.set_position, m.elongation,
                   m.front_force, m.rear_force, m.heat.friction, m.heat.drive, m.heat.coolant,
                   m.heat.air, m.heat.machine, m.heat.stored});
  for (const spindle::BearingState& b : m.bearings)
    good = good && all({b.inner_ring_temperature, b.outer_ring_temperature, b.force, b.power});
  return good && !m.bearings.empty();
}

}  // namespace raceway::robustness
