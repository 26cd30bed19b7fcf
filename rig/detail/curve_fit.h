#pragma once

#include <Eigen/Core>

/// Least squares of a polynomial; shared with the calibration of sensors.
namespace raceway::rig {

/// y = Σ c_k (x/scale)^k fitted to readings.
struct CurveFit {
  double scale = 0.0;              ///< largest |x|
  Eigen::MatrixXd columns{};       ///< (x/scale)^k
  Eigen::VectorXd coefficients{};  ///< c_k, of the scaled powers
  Eigen::VectorXd residuals{};     ///< reading less polynomial
  Eigen::VectorXd free{};          ///< 1 less the leverage of a reading, which is never 0 here
  Eigen::MatrixXd inverse{};       ///< (XᵀX)⁻¹
  double square = 0.0;             ///< sum of squares of the residuals

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  [[nodiscard]] int degrees_of_freedom() const {
    return static_cast<int>(residuals.size() - coefficients.size());
  }
  /// Coefficients of the powers of x.
  [[nodiscard]] Eigen::VectorXd unscaled() const;
};

/// By QR, with one step of refinement. More readings than coefficients, x at as many places.
[[nodiscard]] CurveFit fit_curve(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree);

/// Covariance of the scaled coefficients whatever the scatter of each reading [MacKinnon1985, HC3].
[[nodiscard]] Eigen::MatrixXd robust_covariance(const CurveFit& fit);

/// The chance of so large an F = (square/degrees) / (error_square/error_degrees). Squares up to
/// `floor` are rounding.
[[nodiscard]] double p_of_F(double square, int degrees, double error_square, int error_degrees,
                            double floor);

}  // namespace raceway::rig
