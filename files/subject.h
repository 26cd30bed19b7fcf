#pragma once

#include <memory>

#include "model/model_subject.h"

namespace raceway::files {

/// Subject of a model: a bearing on a rig, or the sets on a shaft.
[[nodiscard]] std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model);

}  // namespace raceway::files
