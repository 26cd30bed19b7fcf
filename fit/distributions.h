#pragma once

/// Probabilities and quantiles of distributions for statistical tests.
///
/// Degrees of freedom are positive and need not be whole numbers. Each function throws
/// std::domain_error for arguments outside its domain.
namespace raceway::fit {

/// Returns the probability that a χ² variable with these degrees of freedom exceeds x; x >= 0.
[[nodiscard]] double chi_squared_above(double degrees, double x);
/// Returns the probability that a χ² variable with these degrees of freedom is below x; x >= 0.
[[nodiscard]] double chi_squared_below(double degrees, double x);

/// Returns the probability that an F variable exceeds x; x >= 0. `degrees` and `error_degrees` are
/// the degrees of freedom of its numerator and its denominator.
[[nodiscard]] double f_above(double degrees, double error_degrees, double x);

/// Returns the probability that a Student t variable with these degrees of freedom exceeds x.
[[nodiscard]] double t_above(double degrees, double x);
/// Returns the value that a Student t variable exceeds with probability p; 0 < p < 1.
[[nodiscard]] double t_exceeded_with(double degrees, double p);

/// Returns the value that a standard normal variable exceeds with probability p; 0 < p < 1.
[[nodiscard]] double normal_exceeded_with(double p);
/// Returns the value below which a standard normal variable lies with probability p; 0 < p < 1.
[[nodiscard]] double normal_quantile(double p);

}  // namespace raceway::fit
