#pragma once

#include <memory>
#include <vector>

#include "model/model_subject.h"

namespace raceway::files {

/// Returns the fit::Subject (a model prepared for fits and diagnosis) of a bearing on a rig, of the
/// bearing sets on a shaft, or of a spindle.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model);
/// Returns the fit::Subject of a model for a record. For the bearing sets on a shaft, the result
/// predicts the friction torque if the record has a torque and no axial displacement, and the axial
/// displacement otherwise.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model,
                                                                      const record::Record& record);

/// Returns all quantities that a model predicts and a record can contain as measurements, with
/// their tolerances.
[[nodiscard]] std::vector<fit::Measured> measurable(const model::Model& model);

}  // namespace raceway::files
