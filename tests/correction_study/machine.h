#pragma once

#include <array>
#include <span>
#include <vector>

#include "tests/correction_study/network.h"

namespace correction_study {

enum Body {
  front_bearing,
  rear_bearing,
  shaft,
  motor,
  housing,
  quill,  ///< carries the tool side, heated by the front bearing alone
  headstock,
  column,
  bed,
  coolant,  ///< jacket, hoses and tank
  screw_x,
  screw_y,
  screw_z,
  mount,  ///< of the displacement probe
  front_sensor,
  rear_sensor,
  motor_sensor,
  body_count
};

/// A sum of sines that nobody would take for periodic.
struct Waves {
  struct Wave {
    double amplitude, period, phase;  ///< [as the sum], [s], [rad]
  };
  std::vector<Wave> waves{};
  [[nodiscard]] double at(double time) const;
};

/// Friction torque of all bearings of the spindle [N m].
///
///   M = m_F (F/500 N)^0.8 (0.6 + 0.4/(1 + n/700 rpm)) + m_v (v(T) n/5000 rpm)^p
///
/// v(T) is the viscosity over that at 40 C. No formula of the library. T > -95 C, n >= 0.
struct TorqueLaw {
  double of_load = 0.11, of_drag = 0.22;  ///< [N m]
  double exponent = 0.6;
  [[nodiscard]] double torque(double speed_rpm, double load, double temperature) const;
};

/// What the plan sets, from one row of a record to the next.
struct Setting {
  double speed = 0.0;            ///< [rpm]
  std::array<double, 3> feed{};  ///< of x, y and z [m/min]
  bool coolant_on = true;
};

/// Something that comes and goes by itself.
struct Intervals {
  std::vector<std::array<double, 2>> on{};  ///< [s], in order
  [[nodiscard]] bool at(double time) const;
};

/// A machine tool whose tool moves along z by what its bodies expand.
struct Machine {
  struct Joint {
    Body a, b;
    double conductance;  ///< [W/K]
  };

  std::array<double, body_count> capacity{};   ///< [J/K]
  std::array<double, body_count> to_air{};     ///< conductance to the room [W/K]
  std::array<double, body_count> expansion{};  ///< of the tool along z [um/K]
  std::vector<Joint> joints{};

  TorqueLaw friction{};
  double load = 500.0;                 ///< [N]
  double front_share = 0.62;           ///< of the friction
  double rotor_to_air = 0.5;           ///< of the shaft, at 10 000 rpm [W/K]
  double motor_low = 30.0;             ///< losses just above standstill [W]
  double motor_fade = 2000.0;          ///< losses fall to a quarter at this speed [rpm]
  double motor_iron = 30.0;            ///< losses at 10 000 rpm [W]
  std::array<double, 3> screw_heat{};  ///< [W min/m]

  double front_to_quill = 6.0;  ///< while heat flows to the quill [W/K]
  double back_flow = 1.0;       ///< the same while heat flows back, over that

  double jacket = 25.0;        ///< housing to coolant, pump on [W/K]
  double motor_jacket = 20.0;  ///< motor to coolant, pump on [W/K]
  double pump_off = 0.04;      ///< share of both without pump
  double chiller = 150.0;      ///< [W/K]
  double chilled_to = 21.5;    ///< [C]

  double room_mean = 21.5;  ///< [C]
  Waves room{};

  /// Displacement by centrifugal forces on the balls: nothing at rest, then a hyperbola.
  double kinematic = 0.0;        ///< at 10 000 rpm [um]
  double kinematic_bend = 2000;  ///< [rpm]

  double warm_mount = 0.0;  ///< of the probe's mount over its surroundings when a run begins [K]
  std::vector<std::array<double, 2>> jumps{};  ///< time [s], step [um]

  /// What no catalogue has.
  Intervals aggregate{};         ///< hydraulics at the column
  double aggregate_power = 0.0;  ///< [W]
  Intervals door{};              ///< a draught on column and headstock
  double draught = 0.0;          ///< [W/K]
  double draught_below = 10.0;   ///< the draught is colder than the room by [K]
  Intervals chips{};             ///< on the headstock's table
  double chips_power = 0.0;      ///< [W]
  Waves humidity{};              ///< displacement by a bed that swells [um]
  double stick = 0.0;            ///< the headstock slides once it is held back by this [um]

  [[nodiscard]] double room_temperature(double time) const;
  [[nodiscard]] double motor_losses(double speed_rpm) const;
  [[nodiscard]] double kinematic_displacement(double speed_rpm) const;
  [[nodiscard]] Flows flows(const Setting& setting, double time, const Eigen::VectorXd& T) const;
  [[nodiscard]] Eigen::VectorXd capacities() const;
};

struct PlannedRow {
  double time;  ///< [s]
  Setting setting;
  int run;
  bool read;  ///< the displacement is read at this row
};

struct Course {
  std::vector<Eigen::VectorXd> temperatures;  ///< at every row [C]
  std::vector<double> displacement;           ///< from the first row of its run on [um]
  std::vector<double> beside;  ///< share of it that no expansion of a body makes [um]
};

/// What happens on the machine, from rest at the first row of every run. Steps of at most
/// `longest` seconds.
[[nodiscard]] Course follow(const Machine& machine, std::span<const PlannedRow> plan,
                            double longest = 4.0);

}  // namespace correction_study
