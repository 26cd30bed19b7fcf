#pragma once

#include <memory>
#include <vector>

#include "model/model_subject.h"

namespace raceway::files {

/// Returns the fit::Subject of a model: a bearing on a rig, the sets on a shaft, or a spindle.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model);
/// Returns the fit::Subject of a model for a record. For the sets on a shaft, the columns of the
/// record determine whether it predicts axial displacement or friction torque.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model,
                                                                      const record::Record& record);

/// Returns all channels that records of a model may measure, with their tolerances.
[[nodiscard]] std::vector<fit::Measured> measurable(const model::Model& model);

}  // namespace raceway::files
