#include "fit/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace raceway::fit {

namespace math = boost::math;

double chi_squared_above(double degrees, double x) {
  return math::cdf(math::complement(math::chi_squared(degrees), x));
}

double chi_squared_below(double degrees, double x) {
  return math::cdf(math::chi_squared(degrees), x);
}

double f_above(double degrees, double error_degrees, double x) {
  return math::cdf(math::complement(math::fisher_f(degrees, error_degrees), x));
}

double t_above(double degrees, double x) {
  return math::cdf(math::complement(math::students_t(degrees), x));
}

double t_exceeded_with(double degrees, double p) {
  return math::quantile(math::complement(math::students_t(degrees), p));
}

double normal_exceeded_with(double p) {
  return math::quantile(math::complement(math::normal(), p));
}

double normal_quantile(double p) { return math::quantile(math::normal(), p); }

}  // namespace raceway::fit
