#include "files/subject.h"

#include "rig/rig_subject.h"
#include "shaft/shaft_subject.h"
#include "spindle/spindle_subject.h"

namespace raceway::files {

std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model) {
  if (model.spindle) return std::make_shared<spindle::SpindleSubject>(model);
  if (model.shaft) return std::make_shared<shaft::ShaftSubject>(model);
  return std::make_shared<rig::RigSubject>(model);
}

}  // namespace raceway::files
