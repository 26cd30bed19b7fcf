#include "model/course.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "record/levels.h"

namespace raceway::model {
namespace {

constexpr double night = 3.0 * 3600.0;  // [s]
constexpr double longer = 3.0;          // than a step between rows that is exceeded by one in ten
constexpr double exceeded_by = 0.1;

/// Step in time that one row in ten exceeds [s].
double usual_step(std::span<const double> time, const std::vector<std::size_t>& order) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < order.size(); ++i)
    steps.push_back(time[order[i]] - time[order[i - 1]]);
  if (steps.empty()) return 0.0;
  const auto at =
      static_cast<std::ptrdiff_t>((1.0 - exceeded_by) * static_cast<double>(steps.size() - 1));
  std::nth_element(steps.begin(), steps.begin() + at, steps.end());
  return steps[static_cast<std::size_t>(at)];
}

/// A value that goes one way until it turns: 1 up, -1 down, 0 while it stays.
class Way {
 public:
  explicit Way(double step) : step_(step) {}
  double operator()(double value) {
    const double change = value - last_;
    if (!(std::abs(change) > step_)) {
      if (std::isnan(last_)) last_ = value;
      return 0.0;
    }
    last_ = value;
    return std::copysign(1.0, change);
  }

 private:
  double step_, last_ = unset;
};

}  // namespace

std::vector<Course> course_of(const record::Record& record) {
  std::vector<Course> course(record.rows());
  if (course.empty() || !record.complete(record::time)) return course;
  const std::span<const double> time = record.values(record::time);
  std::vector<std::size_t> part(record.rows());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = record.part_of(i);
  std::vector<std::size_t> order(record.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return part[a] != part[b] ? part[a] < part[b] : time[a] < time[b];
  });
  const auto step_of = [&](const record::Channel& channel) {
    return record.has(channel) ? record::step_of(channel, record.values(channel)) : 0.0;
  };
  const double pause = std::max(night, longer * usual_step(time, order));
  const auto begins_anew = [&](std::size_t i) {
    return i == 0 || part[order[i]] != part[order[i - 1]];
  };
  const auto rests = [&](std::size_t i) { return time[order[i]] - time[order[i - 1]] > pause; };
  bool by_day = false;
  for (std::size_t i = 1; i < order.size(); ++i) by_day = by_day || (!begins_anew(i) && rests(i));
  Way load(step_of(record::axial_load)), speed(step_of(record::speed));
  double start = unset, loads = 0.0, last = 1.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t row = order[i];
    bool fresh = begins_anew(i);
    if (fresh) {
      load = Way(step_of(record::axial_load));
      speed = Way(step_of(record::speed));
      loads = 0.0;
    }
    const double turned = load(record.value(record::axial_load, row));
    if (by_day) {
      fresh = fresh || rests(i);
    } else if (turned != 0.0) {
      fresh = fresh || turned * loads < 0.0;
      loads = fresh ? 0.0 : turned;
    }
    if (fresh) start = time[row];
    // The first speed of a run, and the first at another load, is reached from rest.
    const double way = speed(record.value(record::speed, row));
    const bool from_rest =
        begins_anew(i) || record.run_of(row) != record.run_of(order[i - 1]) || turned != 0.0;
    if (from_rest)
      last = 1.0;
    else if (way != 0.0)
      last = way;
    course[row] = {.since_start = time[row] - start, .direction = last};
  }
  return course;
}

}  // namespace raceway::model
