#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// Something unknown that changes slowly: a Gauss-Markov process of first order.
///
///   x(t + dt) = a x(t) + w,   a = exp(-dt/T),   w ~ N(0, s² (1 - a²) + q² dt)
///
/// Left alone it returns to 0 with the memory T and is then known to +- s; with T endless it is a
/// constant, or with q a random walk.
struct Unknown {
  std::string name{};
  double std = unset;                                       ///< s, in its unit
  double memory = std::numeric_limits<double>::infinity();  ///< T [s]
  double walk = 0.0;                                        ///< q, its unit by the root of a second
  double first_std = unset;                                 ///< at the beginning; NaN: s
  double bound = std::numeric_limits<double>::infinity();   ///< of its amount
  /// Index of the unknown whose rate this one is, dx_k/dt = x; none where it is negative.
  int rate_of = -1;
};

/// Estimate of a sum of unknowns from occasional readings of it.
///
///   y(t) = sum_j h_j(t) x_j(t) + v,   v ~ N(0, r²)
///
/// A Kalman filter with one scalar reading at a time, in the form of Joseph, which keeps the
/// covariance symmetric and positive semidefinite. For unknowns without bound, walk and rate it is
/// the regression of the readings so far by a Gaussian process of kernel
///
///   k(t, t') = sum_j h_j(t) h_j(t') s_j² exp(-|t - t'|/T_j)
///
/// and where all T_j are endless, recursive least squares with a ridge r²/s².
///
/// Source:   derivation above; tests compare it with the dense solution of the regression.
/// Units:    x_j and h_j any units whose product is the unit of y.
/// Domain:   s_j, T_j, r > 0; time goes forward.
/// Trap:     a bound is kept after each reading by moving along the covariance to where it holds;
///           the covariance is left as it was.
class UnknownsFilter {
 public:
  /// Throws std::invalid_argument for a size or memory that is not positive.
  explicit UnknownsFilter(std::vector<Unknown> unknowns);

  struct Expected {
    double mean = 0.0;
    double variance = 0.0;  ///< of the sum without the noise of a reading
  };
  /// Mean and variance of the sum with weights h, a time dt [s] from now.
  [[nodiscard]] Expected expected(std::span<const double> weights, double dt) const;

  /// Goes on by dt without a reading.
  void advance(double dt);
  /// Learns a reading of the sum with these weights and of this noise, now.
  void learn(std::span<const double> weights, double reading, double reading_std);
  /// Resets one unknown to its initial state.
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
