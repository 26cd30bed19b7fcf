#include "spindle/contact.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <limits>

namespace raceway::spindle {

double constriction_resistance(double semi_axis, double other_semi_axis, double first_conductivity,
                               double second_conductivity) {
  const double a = std::max(semi_axis, other_semi_axis), b = std::min(semi_axis, other_semi_axis);
  if (!(b > 0.0)) return std::numeric_limits<double>::infinity();
  // (1 - b/a)(1 + b/a) rather than 1 - b²/a²: no cancellation near the circle.
  const double modulus = std::sqrt((1.0 - b / a) * (1.0 + b / a));
  return boost::math::ellint_1(modulus) / (2.0 * pi * a) *
         (1.0 / first_conductivity + 1.0 / second_conductivity);
}

}  // namespace raceway::spindle
