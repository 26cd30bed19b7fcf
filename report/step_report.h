#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "report/report.h"
#include "results/step_results.h"

namespace raceway::report {

/// Returns the HTML page of `raceway step-response`. `source` names the model or the file of the
/// step responses. `facts` describes the model; empty if the step responses were imported without a
/// model. `error` describes how far the correction from these step responses deviates from the
/// simulation of `programme`; it is null if this comparison was not requested.
[[nodiscard]] std::string step_report(const std::string& source,
                                      const spindle::StepResponses& responses,
                                      const spindle::PowerLaws& laws,
                                      const std::vector<record::Note>& notes,
                                      const results::Superposition* error,
                                      const std::string& programme,
                                      const std::vector<ModelOfPage>& facts);

}  // namespace raceway::report
