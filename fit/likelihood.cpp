#include "fit/likelihood.h"

#include <cmath>
#include <numbers>

#include "fit/distributions.h"

namespace raceway::fit {

namespace {

constexpr double beyond_chance = 0.01;  // of a misfit against the noise

}  // namespace

double Likelihood::aic() const { return deviance + 2.0 * parameters; }

double Likelihood::bic() const {
  return deviance + parameters * std::log(static_cast<double>(readings));
}

Likelihood likelihood_of(double misfit, const Whitening& whitening, int parameters) {
  const auto readings = static_cast<int>(whitening.std().size());
  Likelihood result{.readings = readings, .parameters = parameters, .chi_square = misfit};
  result.log_determinant =
      readings * std::log(2.0 * std::numbers::pi) + whitening.log_determinant();
  result.deviance = result.chi_square + result.log_determinant;
  return result;
}

double widening(double misfit, int degrees_of_freedom) {
  if (degrees_of_freedom < 1) return 1.0;
  const bool exceeds =
      chi_squared_above(static_cast<double>(degrees_of_freedom), misfit) < beyond_chance;
  return exceeds ? std::sqrt(misfit / degrees_of_freedom) : 1.0;
}

Likelihood likelihood_of_alike(double rmse, int readings, int parameters) {
  Likelihood result{.readings = readings, .parameters = parameters};
  if (rmse > 0.0)
    result.deviance = readings * (1.0 + std::log(2.0 * std::numbers::pi * rmse * rmse));
  return result;
}

}  // namespace raceway::fit
