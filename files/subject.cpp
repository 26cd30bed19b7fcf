#include "files/subject.h"

#include "model/needs.h"
#include "rig/rig_subject.h"
#include "shaft/set_torque_subject.h"
#include "shaft/shaft_subject.h"
#include "spindle/spindle_subject.h"

namespace raceway::files {

std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model) {
  if (model.spindle) return std::make_shared<spindle::SpindleSubject>(model);
  if (model.shaft) return std::make_shared<shaft::ShaftSubject>(model);
  return std::make_shared<rig::RigSubject>(model);
}

std::shared_ptr<const model::ModelSubject> make_subject(const model::Model& model,
                                                        const record::Record& record) {
  if (model.form() == effects::Form::shaft &&
      model::measured_of_shaft(record) == record::friction_torque)
    return std::make_shared<shaft::SetTorqueSubject>(model);
  return make_subject(model);
}

std::vector<fit::Measured> measurable(const model::Model& model) {
  std::vector<fit::Measured> list = make_subject(model)->measured();
  if (model.form() == effects::Form::shaft)
    list.push_back(shaft::SetTorqueSubject(model).measured().front());
  return list;
}

}  // namespace raceway::files
