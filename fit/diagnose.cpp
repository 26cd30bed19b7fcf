#include "fit/diagnose.h"

#include <stdexcept>
#include <string>

#include "fit/approximation_loop.h"
#include "fit/detail/investigation.h"

namespace raceway::fit {

Diagnosis diagnose(const Subject& subject, const Record& record, const DiagnoseOptions& options) {
  constexpr int most_tried = 1'000'000;
  if (options.tried_before < 0 || options.tried_before > most_tried)
    throw std::invalid_argument(
        "explanations tried before = " + std::to_string(options.tried_before) +
        ": must be from 0 to " + std::to_string(most_tried));
  if (subject.approximates()) return diagnose_approximation(subject, record, options);
  if (options.progress) options.progress(0.0, "estimating the noise");
  Investigation investigation(subject, record, options);
  investigation.look();
  if (investigation.is_anything_missing()) {
    investigation.attribute();
    investigation.confirm();
    investigation.try_other_bases();
    investigation.propose();
  }
  return investigation.conclude();
}

}  // namespace raceway::fit
