#include "rig/detail/curve_fit.h"

#include <cmath>

#include "algebra/detail/decompositions.h"
#include "fit/distributions.h"

namespace raceway::rig {

Eigen::VectorXd CurveFit::unscaled() const {
  Eigen::VectorXd b = coefficients;
  for (Eigen::Index k = 0; k < b.size(); ++k) b[k] /= std::pow(scale, k);
  return b;
}

CurveFit fit_curve(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree) {
  // The one reading at its place leaves nothing free but rounding.
  constexpr double least_free = 1e-6;
  CurveFit fit;
  const int size = degree + 1;
  fit.scale = x.cwiseAbs().maxCoeff();
  fit.columns = Eigen::MatrixXd::Ones(x.size(), size);
  for (int k = 1; k < size; ++k)
    fit.columns.col(k) = fit.columns.col(k - 1).cwiseProduct(x / fit.scale);
  const algebra::HouseholderQr qr(fit.columns);
  fit.coefficients = qr.solve(y);
  // What the rounding of the first solution has left is solved for again.
  fit.coefficients += qr.solve(y - fit.columns * fit.coefficients);
  fit.residuals = y - fit.columns * fit.coefficients;
  fit.square = fit.residuals.squaredNorm();
  const Eigen::MatrixXd root = qr.inverse_R();
  fit.inverse = root * root.transpose();
  fit.free = (1.0 - (fit.columns * root).rowwise().squaredNorm().array()).cwiseMax(least_free);
  return fit;
}

Eigen::MatrixXd robust_covariance(const CurveFit& fit) {
  const Eigen::VectorXd e = fit.residuals.cwiseQuotient(fit.free);
  const Eigen::MatrixXd weighted = e.asDiagonal() * fit.columns * fit.inverse;
  return weighted.transpose() * weighted;
}

double p_of_F(double square, int degrees, double error_square, int error_degrees, double floor) {
  if (square <= floor) return 1.0;
  if (error_square <= floor) return 0.0;
  const double f = square / degrees / (error_square / error_degrees);
  return fit::f_above(degrees, error_degrees, f);
}

}  // namespace raceway::rig
