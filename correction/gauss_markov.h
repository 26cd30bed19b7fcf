#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// An unknown x that changes slowly: a first-order Gauss-Markov process.
///
///   x(t + dt) = a x(t) + w,   a = exp(-dt/T),   w ~ N(0, s² (1 - a²) + q² dt)
///
/// w is a random change, and s, q and T are members of this struct. Without readings, the estimate
/// of x returns to 0 with the time constant T. If q = 0, the standard deviation of the estimate
/// returns to s. If T is infinite, x is constant for q = 0 and a random walk for q > 0.
struct Unknown {
  std::string name{};
  double std = unset;  ///< standard deviation s, in the unit of the unknown
  double memory = std::numeric_limits<double>::infinity();  ///< time constant T [s]
  /// q of the random walk, in the unit of the unknown divided by the square root of a second.
  double walk = 0.0;
  double first_std = unset;  ///< standard deviation at the start; if NaN, s is used
  double bound = std::numeric_limits<double>::infinity();  ///< largest allowed absolute value
  /// Index k of the unknown x_k whose rate of change is this unknown, dx_k/dt = x. A negative index
  /// means that this unknown is not a rate of change.
  int rate_of = -1;
};

/// Estimates unknowns x_j from occasional readings y of their weighted sum. The weights h_j are
/// known, and r is the standard deviation of the noise v of a reading.
///
///   y(t) = sum_j h_j(t) x_j(t) + v,   v ~ N(0, r²)
///
/// The class is a Kalman filter in Joseph's form. If no unknown has a random walk (q > 0) or a
/// bound, and no unknown is a rate of change (Unknown::rate_of), the filter is equivalent to a
/// Gaussian-process regression on all readings so far, with the kernel
///
///   k(t, t') = sum_j h_j(t) h_j(t') s_j² exp(-|t - t'|/T_j)
///
/// If all T_j are infinite, the filter is equivalent to recursive least squares with the ridge
/// parameter r²/s_j² for each x_j.
///
/// Source:   Kalman filter. Tests compare the filter with a direct solution of the regression.
/// Units:    x_j and h_j may have any units whose product is the unit of y.
/// Domain:   s_j, T_j, r > 0; time must not decrease.
/// Trap:     an unknown that exceeds its bound after a reading is set to the bound. The other
///           unknowns change according to their covariance with this unknown. The covariance itself
///           does not change.
class UnknownsFilter {
 public:
  /// Throws std::invalid_argument if a standard deviation s or a time constant T is not positive.
  explicit UnknownsFilter(std::vector<Unknown> unknowns);

  struct Expected {
    double mean = 0.0;
    double variance = 0.0;  ///< variance of sum_j h_j x_j, without the noise of a reading
  };
  /// Returns the expected mean and variance of sum_j h_j x_j at the time dt [s] after the present
  /// time of the filter. `weights` contains the h_j.
  [[nodiscard]] Expected expected(std::span<const double> weights, double dt) const;

  /// Advances the filter by the time dt [s] without a reading.
  void advance(double dt);
  /// Updates the unknowns with a reading of their weighted sum at the present time. `reading_std`
  /// is the standard deviation of the noise of this reading.
  void learn(std::span<const double> weights, double reading, double reading_std);
  /// Resets one unknown to the value 0, to its initial standard deviation, and to a covariance of 0
  /// with all other unknowns.
  void reset(std::size_t unknown);

  [[nodiscard]] const std::vector<Unknown>& unknowns() const { return unknowns_; }
  [[nodiscard]] double value(std::size_t unknown) const;
  [[nodiscard]] double std(std::size_t unknown) const;
  [[nodiscard]] bool at_bound(std::size_t unknown) const;

 private:
  void keep_bounds();

  std::vector<Unknown> unknowns_;
  Eigen::VectorXd x_;
  Eigen::MatrixXd p_;
};

}  // namespace raceway::correction
