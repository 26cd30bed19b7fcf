#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "spindle/spindle.h"

/// Handles the rows of a programme and the time steps through them, for spindle/simulator.cpp.
namespace raceway::spindle {

/// Rows of a programme over time. The inputs of a row are valid from the previous row to the time
/// of the row.
class Programme {
 public:
  Programme(std::span<const ProfileRow> rows, double start) : rows_(rows), start_(start) {}

  [[nodiscard]] double begin_of(std::size_t row) const {
    return row == 0 ? start_ : rows_[row - 1].time;
  }
  /// Returns the index after the last row that follows `row` without a jump.
  [[nodiscard]] std::size_t jump_after(std::size_t row) const;
  /// Returns the inputs of a step. Temperatures that change are averaged over the step. `row`
  /// contains the time `from`.
  [[nodiscard]] Inputs mean(std::size_t row, double from, double to) const;

 private:
  std::span<const ProfileRow> rows_;
  double start_;
};

/// Chooses step sizes [s]. Steps are short after a jump of the inputs; later, their size depends on
/// the error.
class StepSizes {
 public:
  static constexpr double longest_unless_given = 600.0;

  /// `tolerance` is the error that a step may have in the temperature of a body [K]. `given`
  /// contains the ends of all steps; it is empty for free step sizes.
  StepSizes(double longest, double tolerance, std::span<const double> given)
      : longest_(longest), tolerance_(tolerance), given_(given) {}

  void jump() { next_ = std::min(first, longest_); }
  void shrink() { next_ *= 0.3; }
  [[nodiscard]] bool too_short() const { return next_ < shortest; }
  [[nodiscard]] bool held() const { return !given_.empty(); }
  /// Returns the step size from `time`. The step does not go beyond `end`, and it does not leave a
  /// very short step before `end`.
  [[nodiscard]] double take(double time, double end);
  /// Returns false if the step must be repeated with a smaller size.
  [[nodiscard]] bool accept(double dt, double error);

 private:
  static constexpr double first = 10.0, shortest = 1e-3;

  double longest_, tolerance_, next_ = first;
  std::span<const double> given_;
  std::size_t place_ = 0;
};

}  // namespace raceway::spindle
