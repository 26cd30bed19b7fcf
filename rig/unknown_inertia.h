#pragma once

#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::rig {

/// Inertia with which the mean torque of a coast-down is that of the model as it stands [kg m²].
///
///   J = Σ M_model / Σ (-dω/dt)
///
/// A coast-down tells M/J alone. A model whose numbers are usual ones fixes the factor to their
/// accuracy, and with it sizes have usual orders; what the record itself tells is the shape of the
/// torque over speed, load and temperature.
///
/// `unit` has the torques of an inertia of 1 kg m². Rows that the model does not predict do not
/// count. Throws std::invalid_argument where the model predicts no torque at any of them.
[[nodiscard]] double matching_inertia(const model::ModelSubject& subject,
                                      const record::Record& unit);

}  // namespace raceway::rig
