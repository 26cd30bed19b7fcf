#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "spindle/spindle.h"

/// Rows of a programme and the steps through them; parts of spindle/simulator.cpp.
namespace raceway::spindle {

/// Rows of a programme over time: each holds from the row before it.
class Programme {
 public:
  Programme(std::span<const ProfileRow> rows, double start) : rows_(rows), start_(start) {}

  [[nodiscard]] double begin_of(std::size_t row) const {
    return row == 0 ? start_ : rows_[row - 1].time;
  }
  /// The row after the last one that goes on from `row` without a jump.
  [[nodiscard]] std::size_t jump_after(std::size_t row) const;
  /// Inputs of a step, wandering temperatures as their mean over it. `row` holds at `from`.
  [[nodiscard]] Inputs mean(std::size_t row, double from, double to) const;

 private:
  std::span<const ProfileRow> rows_;
  double start_;
};

/// Step sizes [s]: short after a jump, then as the error allows.
class StepSizes {
 public:
  static constexpr double longest_unless_given = 600.0;

  /// `tolerance`: error of a step of the warmest body [K]. `given`: ends of all steps, empty where
  /// they are free.
  StepSizes(double longest, double tolerance, std::span<const double> given)
      : longest_(longest), tolerance_(tolerance), given_(given) {}

  void jump() { next_ = std::min(first, longest_); }
  void shrink() { next_ *= 0.3; }
  [[nodiscard]] bool too_short() const { return next_ < shortest; }
  [[nodiscard]] bool held() const { return !given_.empty(); }
  /// The step from `time` on. It ends at `end` at the latest and leaves no stump before it.
  [[nodiscard]] double take(double time, double end);
  /// False where the step is to be repeated with a shorter one.
  [[nodiscard]] bool accept(double dt, double error);

 private:
  static constexpr double first = 10.0, shortest = 1e-3;

  double longest_, tolerance_, next_ = first;
  std::span<const double> given_;
  std::size_t place_ = 0;
};

}  // namespace raceway::spindle
