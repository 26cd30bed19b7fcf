#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "report/report.h"
#include "results/step_results.h"

namespace raceway::report {

/// Returns the page of `raceway step-response`. `source` names the model or the file of the steps.
/// `facts` are empty if the steps were read without a model. `error` is the comparison of the
/// correction with the simulation of `programme`; null if it was not requested.
[[nodiscard]] std::string step_report(const std::string& source,
                                      const spindle::StepResponses& responses,
                                      const spindle::PowerLaws& laws,
                                      const std::vector<record::Note>& notes,
                                      const results::Superposition* error,
                                      const std::string& programme,
                                      const std::vector<ModelOfPage>& facts);

}  // namespace raceway::report
