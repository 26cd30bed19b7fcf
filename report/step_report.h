#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "report/report.h"
#include "results/step_results.h"

namespace raceway::report {

/// Returns the HTML page of `raceway step-response`. `source` names the model or the file of the
/// step responses. `facts` is empty if the step responses were imported without a model. `error` is
/// the difference between the correction from these step responses and the simulation of
/// `programme`; null means that the comparison was not requested.
[[nodiscard]] std::string step_report(const std::string& source,
                                      const spindle::StepResponses& responses,
                                      const spindle::PowerLaws& laws,
                                      const std::vector<record::Note>& notes,
                                      const results::Superposition* error,
                                      const std::string& programme,
                                      const std::vector<ModelOfPage>& facts);

}  // namespace raceway::report
