#include "correction/lag.h"

namespace raceway::correction {

void lag_response(const Clock& clock, std::span<const double> input, Hold hold,
                  double time_constant, double start, std::span<double> state) {
  LagStep step;
  double last = -1.0;
  for (std::size_t k = 0; k < clock.rows(); ++k) {
    if (clock.begins[k]) {
      state[k] = start;
      continue;
    }
    // Most clocks tick evenly: one exponential for the whole record.
    if (clock.steps[k] != last) {
      last = clock.steps[k];
      step = lag_step(last / time_constant, hold);
    }
    const double before = input[hold == Hold::held ? clock.held_until(k) : k - 1];
    state[k] = step.decay * state[k - 1] + step.old_weight * before + step.new_weight * input[k];
  }
}

}  // namespace raceway::correction
