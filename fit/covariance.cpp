#include "fit/covariance.h"

#include <cmath>

namespace raceway::fit {

double Covariance::std(std::size_t parameter) const {
  const auto k = static_cast<Eigen::Index>(parameter);
  return std::sqrt(matrix(k, k));
}

double Covariance::correlation(std::size_t first, std::size_t second) const {
  if (first == second) return 1.0;
  const double scale = std(first) * std(second);
  return scale > 0.0
             ? matrix(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(second)) / scale
             : 0.0;
}

}  // namespace raceway::fit
