#include "rig/unknown_inertia.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace raceway::rig {

double matching_inertia(const model::ModelSubject& subject, const record::Record& unit) {
  std::vector<double> predicted(unit.rows(), unset);
  subject.predictor(unit, {}, subject.prepare(unit))->readings({}, predicted);
  const auto torques = unit.values(record::friction_torque);
  double of_model = 0.0, of_record = 0.0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    if (!std::isfinite(predicted[i])) continue;
    of_model += predicted[i];
    of_record += torques[i];
  }
  if (!(of_model > 0.0 && of_record > 0.0))
    throw std::invalid_argument(unit.source +
                                ": inertia_kgm2 = \"unknown\" needs predicted torques above 0 in "
                                "these rows; enter usual friction factors in the model");
  return of_model / of_record;
}

}  // namespace raceway::rig
