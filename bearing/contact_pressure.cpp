#include "bearing/contact_pressure.h"

#include <algorithm>

namespace raceway::bearing {

ContactPressure largest_pressure(const Bearing& bearing, const BearingEquilibrium& equilibrium) {
  if (!equilibrium.report.converged()) return {};
  double inner = 0.0, outer = 0.0;
  for (const BallEquilibrium& ball : equilibrium.balls.distinct()) {
    inner = std::max(inner, ball.inner_load);
    outer = std::max(outer, ball.outer_load);
  }
  // All contacts of a race have one shape.
  return {.inner = inner > 0.0 ? bearing.contact(Race::inner).peak_pressure(inner) : 0.0,
          .outer = outer > 0.0 ? bearing.contact(Race::outer).peak_pressure(outer) : 0.0};
}

}  // namespace raceway::bearing
