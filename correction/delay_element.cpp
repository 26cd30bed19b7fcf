#include "correction/delay_element.h"

#include <cmath>

namespace raceway::correction {

void delay_response(const Clock& clock, std::span<const double> power, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen) {
  const double limit = element.power_limit();
  for (std::size_t k = 0; k < clock.rows(); ++k) {
    if (clock.begins[k]) {
      displacement[k] = 0.0;
      continue;
    }
    const double P = power[clock.held_until(k)], before = displacement[k - 1];
    if (!(P >= 0.0 && P < limit)) {
      displacement[k] = unset;
      continue;
    }
    const double rise = -std::expm1(-clock.steps[k] / continued(element.time_constant, seen, P));
    const double target = P > 0.0 ? continued(element.gain, seen, P) : 0.0;
    displacement[k] = before + rise * (target - before);
  }
}

}  // namespace raceway::correction
