#include "cli/step_response_text.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/text_table.h"
#include "session/step_parts.h"

namespace raceway::cli {

namespace {

void print_load_steps(const std::vector<spindle::LoadSteps>& loads) {
  fmt::print(
      "\nLoad steps at the nose of the spindle in its steady state: displacement u = u0 + K (1 - "
      "exp(-t/T)) after the time t; u0: column \"at once\";\nRMS: residual; T unloading: time "
      "constant after the load is removed\n\n");
  TextTable table({{"step", "", true},
                   {"at once", "um"},
                   {"K", "um"},
                   {"T", "min"},
                   {"RMS", "um"},
                   {"T unloading", "min"}});
  for (const spindle::LoadSteps& at : loads)
    for (const spindle::StepResponse& s : at.steps)
      table.add({session::name_of(s), number(s.kinematic / um), number(s.fit.one.gain / um),
                 number(s.fit.one.time_constant / spindle::one_minute), number(s.fit.rms / um, 2),
                 number(at.unloaded / spindle::one_minute)});
  fmt::print("{}", table.text(terminal_width()));
}

}  // namespace

void print_steps(const session::SpindleSteps& steps) {
  const spindle::StepResponses& responses = steps.responses;
  const spindle::PowerLaws& laws = steps.laws;
  fmt::print(
      "Step responses of {}: displacement u = kinematic + K (1 - exp(-t/T)) after the time "
      "t;\npower: friction power P at the end of the step;\nRMS: residual with one lag (K, T) and "
      "with two lags (K1, T1, K2, T2)\n\n",
      steps.source);
  TextTable table({{"step", "", true},
                   {"power", "W"},
                   {"kinematic", "um"},
                   {"K", "um"},
                   {"T", "min"},
                   {"RMS", "um"},
                   {"K1", "um"},
                   {"T1", "min"},
                   {"K2", "um"},
                   {"T2", "min"},
                   {"RMS", "um"}});
  for (const spindle::StepResponse& s : responses.steps) {
    const spindle::StepFit& f = s.fit;
    table.add({session::name_of(s), number(s.power_end), number(s.kinematic / um),
               number(f.one.gain / um), number(f.one.time_constant / spindle::one_minute),
               number(f.rms / um, 2), number(f.fast.gain / um),
               number(f.fast.time_constant / spindle::one_minute, 3), number(f.slow.gain / um),
               number(f.slow.time_constant / spindle::one_minute, 3),
               number(f.rms_of_two / um, 2)});
  }
  fmt::print("{}", table.text(terminal_width()));
  if (!responses.loads.empty()) print_load_steps(responses.loads);
  if (responses.cool_down.known())
    fmt::print("cooling from the highest speed to rest: T = {} min\n",
               number(responses.cool_down.one / spindle::one_minute));
  if (std::isnan(laws.gain_line.slope)) return;
  fmt::print("\nK = {} um/W P + {} um, T = {} min/W P + {} min\n",
             number(laws.gain_line.slope / um), number(laws.gain_line.offset / um),
             number(laws.time_line.slope / spindle::one_minute),
             number(laws.time_line.offset / spindle::one_minute));
  if (!std::isnan(laws.gain_power.exponent))
    fmt::print("K = {} um (P/W)^{}, T = {} min (P/W)^{}\n", number(laws.gain_power.factor / um),
               number(laws.gain_power.exponent),
               number(laws.time_power.factor / spindle::one_minute),
               number(laws.time_power.exponent));
}

}  // namespace raceway::cli
