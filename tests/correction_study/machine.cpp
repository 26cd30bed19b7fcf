#include "tests/correction_study/machine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace correction_study {
namespace {

constexpr double rad_s = std::numbers::pi / 30.0;  // of one rpm

/// From 0 to 1 where heat turns round, smooth so that a step settles.
double forward(double difference) { return 0.5 * (1.0 + std::tanh(difference / 0.1)); }

/// A slide that is held until its guide gives way, and then nearly catches up.
class Slide {
 public:
  explicit Slide(double stick) : stick_(stick) {}
  /// How far it is behind.
  double behind(double free) {
    if (stick_ <= 0.0) return 0.0;
    if (std::abs(free - at_) > stick_) at_ = free - 0.1 * (free - at_);
    return free - at_;
  }

 private:
  double stick_, at_ = 0.0;
};

}  // namespace

double Waves::at(double time) const {
  double sum = 0.0;
  for (const Wave& w : waves)
    sum += w.amplitude * std::sin(2.0 * std::numbers::pi * time / w.period + w.phase);
  return sum;
}

bool Intervals::at(double time) const {
  return std::any_of(on.begin(), on.end(),
                     [&](const auto& i) { return time >= i[0] && time < i[1]; });
}

double TorqueLaw::torque(double speed_rpm, double load, double temperature) const {
  const double thinner = std::exp(-5.5 * (temperature - 40.0) / (temperature + 95.0));
  return of_load * std::pow(load / 500.0, 0.8) * (0.6 + 0.4 / (1.0 + speed_rpm / 700.0)) +
         of_drag * std::pow(thinner * speed_rpm / 5000.0, exponent);
}

double Machine::room_temperature(double time) const { return room_mean + room.at(time); }

double Machine::motor_losses(double speed_rpm) const {
  if (speed_rpm <= 0.0) return 0.0;
  const double fading = 1.0 / (1.0 + speed_rpm / motor_fade);
  return motor_low * fading * fading + motor_iron * speed_rpm / 10000.0;
}

double Machine::kinematic_displacement(double speed_rpm) const {
  const auto hyperbola = [&](double n) { return std::hypot(n, kinematic_bend) - kinematic_bend; };
  return kinematic * hyperbola(speed_rpm) / hyperbola(10000.0);
}

Eigen::VectorXd Machine::capacities() const {
  return Eigen::Map<const Eigen::VectorXd>(capacity.data(), body_count);
}

Flows Machine::flows(const Setting& setting, double time, const Eigen::VectorXd& T) const {
  Flows f(body_count);
  const double air = room_temperature(time);
  for (const Joint& j : joints) f.join(j.a, j.b, j.conductance);
  for (int i = 0; i < body_count; ++i) f.expose(i, to_air[static_cast<std::size_t>(i)], air);

  const double turning = setting.speed / 10000.0;
  f.expose(shaft, rotor_to_air * std::pow(turning, 0.9), air);
  const double to_quill = forward(T[front_bearing] - T[quill]);
  f.join(front_bearing, quill, front_to_quill * (to_quill + back_flow * (1.0 - to_quill)));

  const double pump = setting.coolant_on ? 1.0 : pump_off;
  f.join(housing, coolant, pump * jacket);
  f.join(motor, coolant, pump * motor_jacket);
  f.expose(coolant, chiller, chilled_to);

  const double omega = setting.speed * rad_s;
  const auto friction_heat = [&](Body bearing, double share) {
    f.heat(bearing, share * omega * friction.torque(setting.speed, load, T[bearing]));
  };
  friction_heat(front_bearing, front_share);
  friction_heat(rear_bearing, 1.0 - front_share);
  f.heat(motor, motor_losses(setting.speed));
  for (std::size_t axis = 0; axis < 3; ++axis)
    f.heat(screw_x + static_cast<int>(axis), screw_heat[axis] * std::abs(setting.feed[axis]));

  if (aggregate.at(time)) f.heat(column, aggregate_power);
  if (chips.at(time)) f.heat(headstock, chips_power);
  if (door.at(time)) {
    f.expose(column, draught, air - draught_below);
    f.expose(headstock, 0.4 * draught, air - draught_below);
  }
  return f;
}

Course follow(const Machine& machine, std::span<const PlannedRow> plan, double longest) {
  Course course;
  const Eigen::VectorXd capacity = machine.capacities();
  Eigen::VectorXd start, T;
  Slide slide(0.0);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const PlannedRow& row = plan[i];
    if (i == 0 || row.run != plan[i - 1].run) {
      Setting standing = row.setting;
      standing.speed = 0.0;
      standing.feed = {};
      const FlowsAt at_rest = [&](double time, const Eigen::VectorXd& state) {
        return machine.flows(standing, time, state);
      };
      T = rest(at_rest, row.time,
               Eigen::VectorXd::Constant(body_count, machine.room_temperature(row.time)));
      T[mount] += machine.warm_mount;
      start = T;
      slide = Slide(machine.stick);
    } else {
      const PlannedRow& before = plan[i - 1];
      const FlowsAt flows = [&](double time, const Eigen::VectorXd& state) {
        return machine.flows(before.setting, time, state);
      };
      T = advance(capacity, flows, before.time, row.time - before.time, longest, T);
    }
    double expanded = 0.0;
    for (int b = 0; b < body_count; ++b)
      expanded += machine.expansion[static_cast<std::size_t>(b)] * (T[b] - start[b]);
    double beside = machine.kinematic_displacement(row.setting.speed) +
                    machine.humidity.at(row.time) - slide.behind(expanded);
    for (const auto& [time, by] : machine.jumps) beside += row.time >= time ? by : 0.0;
    course.temperatures.push_back(T);
    course.displacement.push_back(expanded + beside);
    course.beside.push_back(beside);
  }
  return course;
}

}  // namespace correction_study
