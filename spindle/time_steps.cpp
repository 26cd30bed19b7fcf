#include "spindle/detail/time_steps.h"

namespace raceway::spindle {
namespace {

/// Room, machine and coolant may wander by this between two rows without a step boundary [K].
constexpr double wandering = 0.5;

bool near(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= wandering;
}
bool same(double a, double b) { return (std::isnan(a) && std::isnan(b)) || a == b; }

/// Whether inputs go on without a jump.
bool goes_on(const Inputs& a, const Inputs& b) {
  return a.speed == b.speed && a.coolant_on == b.coolant_on && a.axial_load == b.axial_load &&
         a.radial_load == b.radial_load && a.moment == b.moment &&
         same(a.belt_force, b.belt_force) && same(a.motor_heat, b.motor_heat) &&
         same(a.motor_power, b.motor_power) && near(a.ambient_temperature, b.ambient_temperature) &&
         near(a.machine_temperature, b.machine_temperature) &&
         near(a.coolant_inlet, b.coolant_inlet);
}

}  // namespace

std::size_t Programme::jump_after(std::size_t row) const {
  std::size_t next = row + 1;
  while (next < rows_.size() && goes_on(rows_[next - 1].inputs, rows_[next].inputs)) ++next;
  return next;
}

Inputs Programme::mean(std::size_t row, double from, double to) const {
  Inputs inputs = rows_[row].inputs;
  double ambient = 0.0, machine = 0.0, inlet = 0.0, length = 0.0;
  for (std::size_t k = row; k < rows_.size() && begin_of(k) < to; ++k) {
    const double part = std::min(rows_[k].time, to) - std::max(begin_of(k), from);
    if (!(part > 0.0)) continue;
    length += part;
    ambient += part * rows_[k].inputs.ambient_temperature;
    machine += part * rows_[k].inputs.machine_temperature;
    inlet += part * rows_[k].inputs.coolant_inlet;
  }
  if (length > 0.0) {
    inputs.ambient_temperature = ambient / length;
    inputs.machine_temperature = machine / length;
    inputs.coolant_inlet = inlet / length;
  }
  return inputs;
}

double StepSizes::take(double time, double end) {
  while (place_ < given_.size() && given_[place_] <= time * (1.0 + 1e-14)) ++place_;
  if (place_ < given_.size()) return std::min(given_[place_], end) - time;
  const double left = end - time;
  if (next_ >= left) return left;
  return next_ > 0.5 * left ? 0.5 * left : next_;
}

bool StepSizes::accept(double dt, double error) {
  const double factor = 0.85 * std::cbrt(tolerance_ / std::max(error, 1e-6 * tolerance_));
  if (!held() && error > 2.0 * tolerance_ && dt > 10.0 * shortest) {
    next_ = dt * std::clamp(factor, 0.2, 0.7);
    return false;
  }
  next_ = std::min(dt * std::clamp(factor, 0.3, 2.5), longest_);
  return true;
}

}  // namespace raceway::spindle
