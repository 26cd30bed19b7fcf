#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Assumed shape of an input between two samples.
enum class Hold {
  straight,  ///< first-order hold: a straight line, as for temperatures
  held       ///< zero-order hold: constant at the value of the earlier or the later sample
             ///< (see Clock::settings_hold)
};

/// Coefficients for one time step dt of a first-order lag T dx/dt = u - x, with the input u, the
/// state x and the time constant T.
///
///   x(k+1) = decay x(k) + old_weight u(k) + new_weight u(k+1)
///
/// Source:   exact solution of the equation for an input that is linear or constant between
///           samples.
/// Domain:   0 <= dt/T.
/// Accuracy: rounding error only, also for small dt/T.
struct LagStep {
  double decay = 1.0, old_weight = 0.0, new_weight = 0.0;  ///< [1]
};

/// Returns the coefficients for a step with dt/T = `ratio` [1].
inline LagStep lag_step(double ratio, Hold hold) {
  const double rise = -std::expm1(-ratio);  // 1 - exp(-ratio)
  if (hold == Hold::held) return {1.0 - rise, rise, 0.0};
  // 1 - rise/ratio loses digits for small ratios. The series is exact to rounding there.
  const double new_weight =
      ratio < 1e-2
          ? ratio * (1.0 / 2 -
                     ratio * (1.0 / 6 -
                              ratio * (1.0 / 24 -
                                       ratio * (1.0 / 120 - ratio * (1.0 / 720 - ratio / 5040)))))
          : 1.0 - rise / ratio;
  return {1.0 - rise, rise - new_weight, new_weight};
}

/// Time steps between the rows of a record, and the first rows of its runs.
struct Clock {
  std::vector<double> steps{};  ///< time since the previous row [s]; 0 at the start of a run
  std::vector<bool> begins{};   ///< true if a run begins with this row
  record::SettingsHold settings_hold = record::SettingsHold::sampled;

  [[nodiscard]] std::size_t rows() const { return steps.size(); }
  /// Returns the row whose speeds, feeds and powers apply between the previous row and `row`. `row`
  /// must not be the first row of a run.
  [[nodiscard]] std::size_t held_until(std::size_t row) const {
    return settings_hold == record::SettingsHold::until_row ? row : row - 1;
  }
  /// Returns the row whose speeds, feeds and powers apply at the time of the reading in `row`.
  [[nodiscard]] std::size_t seen_at(std::size_t row) const {
    return settings_hold == record::SettingsHold::from_row && !begins[row] ? row - 1 : row;
  }
};

/// Computes the state of a first-order lag at every row, in the unit of the input. `time_constant`
/// [s] is above 0. Every run begins with the state `start`. `input` and `state` have one value per
/// row.
void lag_response(const Clock& clock, std::span<const double> input, Hold hold,
                  double time_constant, double start, std::span<double> state);

}  // namespace raceway::correction
