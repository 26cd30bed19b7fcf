#pragma once

#include <memory>
#include <vector>

#include "model/model_subject.h"

namespace raceway::files {

/// Subject of a model: a bearing on a rig, or the sets on a shaft.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model);
/// Returns the same for a record. Of the sets on a shaft, the record has the axial displacement or
/// the friction torque.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model,
                                                                      const record::Record& record);

/// Returns all channels that records of a model may measure, with their tolerances.
[[nodiscard]] std::vector<fit::Measured> measurable(const model::Model& model);

}  // namespace raceway::files
