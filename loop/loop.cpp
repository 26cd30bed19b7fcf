#include "loop/loop.h"

#include <stdexcept>

#include "tolerance/approximation_loop.h"

namespace raceway::loop {

verdict::Calibration calibrate(const fit::Subject& subject, const record::Record& record,
                               const verdict::CalibrateOptions& options) {
  if (!subject.approximates()) return verdict::calibrate_by_noise(subject, record, options);
  if (options.profile)
    throw std::invalid_argument(
        "profile likelihood intervals need readings with independent noise; the residuals of a "
        "record over time are correlated");
  return tolerance::calibrate_approximation(subject, record);
}

verdict::Diagnosis diagnose(const fit::Subject& subject, const record::Record& record,
                            const verdict::DiagnoseOptions& options) {
  constexpr int most_tried = 1'000'000;
  if (options.tried_before < 0 || options.tried_before > most_tried)
    throw std::invalid_argument(
        "tried_before (explanations tried earlier) = " + std::to_string(options.tried_before) +
        ": must be from 0 to " + std::to_string(most_tried));
  return subject.approximates() ? tolerance::diagnose_approximation(subject, record, options)
                                : verdict::diagnose_by_noise(subject, record, options);
}

verdict::AddResult add(const fit::Subject& subject, std::span<const std::string> ids,
                       const record::Record& record) {
  return subject.approximates() ? tolerance::add_approximation(subject, ids, record)
                                : verdict::add_by_noise(subject, ids, record);
}

}  // namespace raceway::loop
