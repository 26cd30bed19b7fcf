#pragma once

/// Probabilities of the usual tests, compiled once: Boost.Math's distributions take seconds in
/// every file that uses them.
///
/// Degrees of freedom are positive and need not be whole. Each function throws std::domain_error
/// for arguments outside of its domain.
namespace raceway::fit {

/// Probability that χ² of these degrees of freedom exceeds x; x >= 0.
[[nodiscard]] double chi_squared_above(double degrees, double x);
/// Probability that it does not.
[[nodiscard]] double chi_squared_below(double degrees, double x);

/// Probability that F of these degrees of freedom exceeds x; x >= 0.
[[nodiscard]] double f_above(double degrees, double error_degrees, double x);

/// Probability that Student's t exceeds x.
[[nodiscard]] double t_above(double degrees, double x);
/// The x that Student's t exceeds with probability p; 0 < p < 1.
[[nodiscard]] double t_exceeded_with(double degrees, double p);

/// The x that a standard normal number exceeds with probability p; 0 < p < 1.
[[nodiscard]] double normal_exceeded_with(double p);
/// The x that it stays below with probability p; 0 < p < 1.
[[nodiscard]] double normal_quantile(double p);

}  // namespace raceway::fit
