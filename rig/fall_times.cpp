#include "rig/fall_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace raceway::rig {
namespace {

constexpr double lone_exponent = 2.0 / 3.0;
constexpr double steepest = 4.0;  // of p and of p'/p: beyond it is scatter

/// Mean torque over a fall against the middle of its speeds.
struct Point {
  double x, y;        // ln ω, ln M
  double half_width;  // of the fall, as a share of ω
};

/// p and p'/p of ln M over ln ω.
struct Shape {
  double exponent = lone_exponent, bend = 0.0;
};

/// Rows that differ in nothing but the speed.
bool comparable(const record::Record& record, std::size_t a, std::size_t b) {
  if (record.run_of(a) != record.run_of(b)) return false;
  return std::all_of(record.columns.begin(), record.columns.end(), [&](const record::Column& c) {
    if (!c.channel->is_input() || *c.channel == record::speed) return true;
    const double x = c.values[a], y = c.values[b];
    const double size = c.channel->ratio ? std::fmax(std::abs(x), std::abs(y)) : 1.0;
    return !(std::abs(x - y) > c.channel->step * size);
  });
}

/// The nearest of `others` on one side of `x`, further off than `gap`; null if there is none.
const Point* nearest(const std::vector<Point>& others, double x, double gap, double side) {
  const Point* found = nullptr;
  for (const Point& p : others)
    if (side * (p.x - x) > gap && (!found || side * (p.x - found->x) < 0.0)) found = &p;
  return found;
}

Shape shape_at(const Point& here, const std::vector<Point>& others) {
  const double gap = here.half_width;
  const Point* below = nearest(others, here.x, gap, -1.0);
  const Point* above = nearest(others, here.x, gap, 1.0);
  if (!below && !above) return {};
  // At an end of the run the second neighbour stands beyond the first.
  if (!below) below = nearest(others, above->x, gap, 1.0);
  if (!above) above = nearest(others, below->x, gap, -1.0);
  Shape shape;
  double change = 0.0;
  if (below && above) {
    const double a = below->x - here.x, b = above->x - here.x;
    const double rise_a = (below->y - here.y) / a, rise_b = (above->y - here.y) / b;
    change = 2.0 * (rise_b - rise_a) / (b - a);
    shape.exponent = rise_a - 0.5 * change * a;
  } else {
    const Point* only = below ? below : above;
    shape.exponent = (only->y - here.y) / (only->x - here.x);
  }
  shape.exponent = std::clamp(shape.exponent, -steepest, steepest);
  const double limit = steepest * std::abs(shape.exponent);
  shape.bend = limit > 0.0 ? std::clamp(change, -limit, limit) / shape.exponent : 0.0;
  return shape;
}

void check(const record::Record& record, std::span<const Fall> falls, const model::Rig& rig) {
  if (!(rig.inertia > 0.0) || !std::isfinite(rig.inertia))
    throw std::invalid_argument(
        fmt::format("inertia = {} kg m2: must be above 0; the torque from the time between two "
                    "speeds is M = J (w1 - w2)/t (J: inertia, w1, w2: angular speeds, t: time)",
                    rig.inertia));
  if (falls.size() != record.rows())
    throw std::invalid_argument(fmt::format(
        "{}: times between two speeds are given for {} of {} rows; each row needs one time",
        record.source, falls.size(), record.rows()));
  for (std::size_t i = 0; i < falls.size(); ++i) {
    const Fall& f = falls[i];
    if (!(f.to > 0.0 && f.from > f.to && f.time > 0.0 && std::isfinite(f.from / f.time)))
      throw std::invalid_argument(
          fmt::format("{}, {}: from {} to {} rad/s in {} s: the speed must fall and stay above 0, "
                      "and the time must be above 0",
                      record.source, record.place(i), f.from, f.to, f.time));
  }
}

}  // namespace

double speed_of_mean_torque(double from, double to, double exponent) {
  const double ratio = std::log(from / to);
  const auto log_power_mean = [&](double q) {  // ln of (e^(q L) - 1)/q
    return std::log(std::abs(q) < 1e-9 ? ratio : std::expm1(q * ratio) / q);
  };
  if (std::abs(exponent) < 1e-5)  // mean of the logarithm
    return to * std::exp(ratio * from / (from - to) - 1.0);
  return to * std::exp((log_power_mean(1.0) - log_power_mean(1.0 - exponent)) / exponent);
}

record::Record fall_torque(const record::Record& record, std::span<const Fall> falls,
                           const model::Rig& rig) {
  check(record, falls, rig);
  std::vector<double> torque, speed, deviation;
  std::vector<Point> points;
  for (const Fall& f : falls) {
    torque.push_back(rig.inertia * (f.from - f.to) / f.time);
    deviation.push_back(torque.back() * f.time_deviation / f.time);
    const double middle = 0.5 * (f.from + f.to);
    points.push_back({std::log(middle), std::log(torque.back()), 0.5 * (f.from - f.to) / middle});
  }
  double lowest = steepest, highest = -steepest;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    std::vector<Point> others;
    for (std::size_t k = 0; k < falls.size(); ++k)
      if (k != i && comparable(record, i, k)) others.push_back(points[k]);
    const Shape shape = shape_at(points[i], others);
    const double width = points[i].half_width;  // s/2
    speed.push_back(speed_of_mean_torque(falls[i].from, falls[i].to, shape.exponent) *
                    (1.0 + shape.bend * width * width / 6.0));
    lowest = std::min(lowest, shape.exponent);
    highest = std::max(highest, shape.exponent);
  }
  record::Record result = record;
  result.set(record::speed, std::move(speed));
  result.set(record::friction_torque, std::move(torque));
  if (std::all_of(deviation.begin(), deviation.end(), [](double d) { return d > 0.0; }))
    result.set(record::torque_deviation, std::move(deviation));
  result.notes.push_back(record::note::read_as(fmt::format(
      "{} torques from the times between two speeds, M = J (w1 - w2)/t with J = {:.6g} "
      "kg m2; the speed of each torque is the speed at which the shaft had this torque, "
      "calculated with M ~ n^p (n: speed), p = {:.2f} to {:.2f}",
      falls.size(), rig.inertia, lowest, highest)));
  return result;
}

}  // namespace raceway::rig
