#pragma once

#include <Eigen/Core>

/// Fits a polynomial by least squares, for the calibration of sensors.
namespace raceway::rig {

/// Polynomial y = Σ c_k (x/scale)^k fitted to readings.
struct CurveFit {
  double scale = 0.0;              ///< largest |x|
  Eigen::MatrixXd columns{};       ///< (x/scale)^k
  Eigen::VectorXd coefficients{};  ///< coefficients c_k of the scaled powers
  Eigen::VectorXd residuals{};     ///< reading minus polynomial
  Eigen::VectorXd free{};          ///< 1 minus the leverage of each reading, at least 1e-6
  Eigen::MatrixXd inverse{};       ///< (XᵀX)⁻¹ with X = `columns`
  double square = 0.0;             ///< sum of squares of the residuals

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  [[nodiscard]] int degrees_of_freedom() const {
    return static_cast<int>(residuals.size() - coefficients.size());
  }
  /// Returns the coefficients of the powers of x.
  [[nodiscard]] Eigen::VectorXd unscaled() const;
};

/// Fits the polynomial by QR decomposition with one step of iterative refinement. There must be
/// more readings than coefficients, and x must have at least as many different values as
/// coefficients.
[[nodiscard]] CurveFit fit_curve(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree);

/// Returns the covariance of the scaled coefficients. The covariance is valid even if the scatter
/// differs between readings [MacKinnon1985, HC3].
[[nodiscard]] Eigen::MatrixXd robust_covariance(const CurveFit& fit);

/// Returns the p-value of F = (square/degrees) / (error_square/error_degrees). Sums of squares up
/// to `floor` are treated as rounding errors.
[[nodiscard]] double p_of_F(double square, int degrees, double error_square, int error_degrees,
                            double floor);

}  // namespace raceway::rig
