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
/// Without readings, the estimate of x returns to 0 with the time constant T. If q = 0, its
/// standard deviation returns to s. With infinite T, x is constant if q = 0, otherwise a random
/// walk.
struct Unknown {
  std::string name{};
  double std = unset;  ///< standard deviation s, in the unit of the unknown
  double memory = std::numeric_limits<double>::infinity();  ///< time constant T [s]
  double walk = 0.0;         ///< q, in the unit of the unknown per root of a second
  double first_std = unset;  ///< standard deviation at the start; NaN: s
  double bound = std::numeric_limits<double>::infinity();  ///< largest allowed absolute value
  /// Index k of another unknown if this unknown is its rate of change, dx_k/dt = x; negative: it is
  /// not a rate.
  int rate_of = -1;
};

/// Estimates unknowns x_j from occasional readings y of their weighted sum with known weights h_j.
///
///   y(t) = sum_j h_j(t) x_j(t) + v,   v ~ N(0, r²)
///
/// Kalman filter that processes one scalar reading at a time in Joseph's form, which keeps the
/// covariance symmetric and positive semidefinite. Without bounds, walks and rates, the filter is
/// equivalent to a Gaussian-process regression on all readings so far with the kernel
///
///   k(t, t') = sum_j h_j(t) h_j(t') s_j² exp(-|t - t'|/T_j)
///
/// With infinite T_j, the filter is recursive least squares with the ridge parameter r²/s_j² for
/// each x_j.
///
/// Source:   the equations above. Tests compare the filter with a direct solution of the
///           regression.
/// Units:    x_j and h_j may have any units whose product is the unit of y.
/// Domain:   s_j, T_j, r > 0; time must not go back.
/// Trap:     if an unknown exceeds its bound after a reading, it is set to the bound, and the other
///           unknowns are moved according to their covariance with it. The covariance does not
///           change.
class UnknownsFilter {
 public:
  /// Throws std::invalid_argument if a standard deviation s or a time constant T is not positive.
  explicit UnknownsFilter(std::vector<Unknown> unknowns);

  struct Expected {
    double mean = 0.0;
    double variance = 0.0;  ///< variance of the sum, without the noise of a reading
  };
  /// Returns the expected mean and variance of the sum with these weights, at the time dt [s] after
  /// the present time of the filter.
  [[nodiscard]] Expected expected(std::span<const double> weights, double dt) const;

  /// Advances the filter by the time dt [s] without a reading.
  void advance(double dt);
  /// Updates the unknowns with a reading of their weighted sum at the present time. `reading_std`
  /// is the standard deviation of its noise.
  void learn(std::span<const double> weights, double reading, double reading_std);
  /// Sets one unknown to 0 with its initial standard deviation, and its covariance with the others
  /// to 0.
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
