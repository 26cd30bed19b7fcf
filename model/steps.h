#pragma once

#include <cstddef>
#include <vector>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// True if the law or an effect of the model uses ball loads or angles. The laws for the bearing as
/// a whole do not, so with them one whose load is only assumed can be compared without a solve.
[[nodiscard]] bool needs_equilibrium(const Model& model);

/// Effects of a model by the step at which they act; found once for many predictions.
struct Steps {
  /// Indices into Model::effects; `reading` belongs to the channel that is read.
  std::vector<std::size_t> entry, condition, lubricant, moment, reading;
  bool equilibrium = false;  ///< of balls or rollers, to be solved
  bool needs_balls = false;  ///< without it there is no prediction
  explicit Steps(const Model& model, bool with_equilibrium = false,
                 const record::Channel& read = record::friction_torque);
};

/// The first thing that a changed number of a model can change.
enum class Stage { entry, condition, lubricant, base, moment, reading };

/// The stage that a number of the base law (`effect` < 0) or of an effect acts on first.
[[nodiscard]] Stage first_stage(const Model& model, const Steps& steps, int effect);

/// The state of one bearing that friction laws and effects look at, as entered; `equilibrium` may
/// be null.
[[nodiscard]] friction::BearingState<double> bearing_state(
    const Model& model, const bearing::OperatingPoint& point,
    const bearing::BearingEquilibrium* equilibrium);

/// Condition of a bearing in the state `entered`: `given`, then changed by the effects of a model;
/// not finite where an input is not known. The bearing may be another one than the model's.
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given = {});
/// Condition of a bearing, with its power at the entered load known [W].
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given, double power);

/// True if an effect on the condition looks at the power of the base law at the entered load.
[[nodiscard]] bool uses_power(const Model& model, const Steps& steps);
/// Power of the base law at the entered load [W]; for the contact law, the balls are solved first.
[[nodiscard]] double entered_power(const Model& model, friction::BearingState<double> entered,
                                   const bearing::OperatingPoint& point);

}  // namespace raceway::model
