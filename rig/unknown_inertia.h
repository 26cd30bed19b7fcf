#pragma once

#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::rig {

/// Returns the inertia for which the mean torque of a coast-down equals the mean torque of the
/// model with its current parameters [kg m²].
///
///   J = Σ M_model / Σ (-dω/dt)
///
/// A coast-down determines only the ratio of torque M to inertia J. With typical friction
/// parameters, the result has the correct order of magnitude. The record still shows how the torque
/// depends on speed, load and temperature.
///
/// `unit` is the record with the torques for an inertia of 1 kg m². Rows without a prediction are
/// not used. Throws std::invalid_argument unless both sums are positive.
[[nodiscard]] double matching_inertia(const model::ModelSubject& subject,
                                      const record::Record& unit);

}  // namespace raceway::rig
