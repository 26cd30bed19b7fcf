#include "correction/delay_element.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace raceway::correction {

Interval DelayElement::domain() const {
  Interval takes = time_constant.positive_within();
  if (!both_signs || std::holds_alternative<Characteristic::Power>(gain.form()))
    takes.lower = std::max(takes.lower, 0.0);
  return takes;
}

void delay_response(const Clock& clock, std::span<const double> input, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen) {
  const Interval takes = element.domain();
  for (std::size_t k = 0; k < clock.rows(); ++k) {
    if (clock.begins[k]) {
      displacement[k] = 0.0;
      continue;
    }
    const double x = input[clock.held_until(k)], before = displacement[k - 1];
    if (!(x >= takes.lower && x < takes.upper)) {
      displacement[k] = unset;
      continue;
    }
    const double rise = -std::expm1(-clock.steps[k] / continued(element.time_constant, seen, x));
    const double target = x != 0.0 ? continued(element.gain, seen, x) : 0.0;
    displacement[k] = before + rise * (target - before);
  }
}

}  // namespace raceway::correction
