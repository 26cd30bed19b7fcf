#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "spindle/spindle.h"

/// Handles the rows of a speed programme and the time steps between them, for
/// spindle/simulator.cpp.
namespace raceway::spindle {

/// Rows of a speed programme. The inputs of a row apply from the time of the previous row to the
/// time of this row.
class Programme {
 public:
  Programme(std::span<const ProfileRow> rows, double start) : rows_(rows), start_(start) {}

  [[nodiscard]] double begin_of(std::size_t row) const {
    return row == 0 ? start_ : rows_[row - 1].time;
  }
  /// Returns the index of the first row after `row` whose inputs jump relative to the row before
  /// it; the number of rows if there is no such row. A jump is a change of speed, loads, motor heat
  /// or motor power, coolant switched on or off, or a change of ambient, machine or coolant inlet
  /// temperature by more than 0.5 K.
  [[nodiscard]] std::size_t jump_after(std::size_t row) const;
  /// Returns the inputs of a step between two times [s]. Ambient, machine and coolant temperatures
  /// are averaged over the step. `row` is the row whose inputs apply at the time `from`.
  [[nodiscard]] Inputs mean(std::size_t row, double from, double to) const;

 private:
  std::span<const ProfileRow> rows_;
  double start_;
};

/// Chooses step sizes [s]. If the caller gives the end times of the steps, these determine the
/// sizes. Otherwise, the steps are short after a jump of the inputs, and the estimated temperature
/// error determines each later step size.
class StepSizes {
 public:
  static constexpr double longest_unless_given = 600.0;

  /// `longest` is the longest step [s]. `tolerance` is the allowed temperature error of a step [K].
  /// `given` contains the end times of all steps [s]; if it is empty, this class chooses the step
  /// sizes.
  StepSizes(double longest, double tolerance, std::span<const double> given)
      : longest_(longest), tolerance_(tolerance), given_(given) {}

  void jump() { next_ = std::min(first, longest_); }
  void shrink() { next_ *= 0.3; }
  [[nodiscard]] bool too_short() const { return next_ < shortest; }
  [[nodiscard]] bool held() const { return !given_.empty(); }
  /// Returns the size of the step that starts at `time` [s]. The step never ends after `end`. If
  /// no end times are given, and one step does not reach `end` but two steps would pass it, the
  /// step is half of the time until `end`.
  [[nodiscard]] double take(double time, double end);
  /// Chooses the next step size from the size `dt` [s] and the error [K] of a step. Returns false
  /// if the step must be repeated with a smaller size.
  [[nodiscard]] bool accept(double dt, double error);

 private:
  static constexpr double first = 10.0, shortest = 1e-3;

  double longest_, tolerance_, next_ = first;
  std::span<const double> given_;
  std::size_t place_ = 0;
};

}  // namespace raceway::spindle
