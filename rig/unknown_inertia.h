#pragma once

#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::rig {

/// Inertia with which the mean torque of a coast-down equals the model's as it stands [kg m²].
///
///   J = Σ M_model / Σ (-dω/dt)
///
/// A coast-down determines M/J alone. A model with typical parameters fixes the factor to their
/// accuracy, which gives the usual orders of magnitude. The record itself determines the shape of
/// the torque over speed, load and temperature.
///
/// `unit` has the torques of an inertia of 1 kg m². Rows that the model does not predict do not
/// count. Throws std::invalid_argument where the model predicts no torque at any of them.
[[nodiscard]] double matching_inertia(const model::ModelSubject& subject,
                                      const record::Record& unit);

}  // namespace raceway::rig
