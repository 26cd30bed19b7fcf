#pragma once

#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::rig {

/// Returns the inertia J for which the mean torque of a coast-down equals the mean torque of the
/// model with its current parameters [kg m²].
///
///   J = Σ M_model / Σ (-dω/dt)
///
/// M_model is the torque by the model, and -dω/dt the deceleration. A coast-down alone determines
/// only the ratio of torque to inertia. If the friction parameters of the model are typical, J has
/// the correct order of magnitude. Even without the true inertia, the record shows how the torque
/// depends on speed, load and temperature.
///
/// `unit` is the record of the coast-down. Its torques were computed for an inertia of 1 kg m².
/// Rows without a prediction are not used. Throws std::invalid_argument unless both sums of the
/// formula are positive.
[[nodiscard]] double matching_inertia(const model::ModelSubject& subject,
                                      const record::Record& unit);

}  // namespace raceway::rig
