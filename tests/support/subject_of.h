#pragma once

#include <memory>

#include "rig/rig_subject.h"
#include "shaft/shaft_subject.h"

namespace raceway::fit {

/// A model as the loop sees it.
inline std::unique_ptr<Subject> subject_of(const model::Model& model) {
  if (model.shaft) return std::make_unique<shaft::ShaftSubject>(model);
  return std::make_unique<rig::RigSubject>(model);
}

}  // namespace raceway::fit
