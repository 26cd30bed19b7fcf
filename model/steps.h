#pragma once

#include <cstddef>
#include <vector>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Returns true if the friction law or an effect of the model uses the loads or contact angles of
/// single balls. Otherwise, a prediction needs no ball equilibrium.
[[nodiscard]] bool needs_equilibrium(const Model& model);

/// Effects of a model, grouped by the stage of the prediction that they change (Stage). Create this
/// object once for many predictions.
struct Steps {
  /// Indices in Model::effects. `reading` contains the effects that change the reading of a sensor.
  std::vector<std::size_t> entry, condition, lubricant, moment, reading;
  bool equilibrium = false;  ///< true: the prediction solves the equilibrium of balls or rollers
  bool needs_balls = false;  ///< true: without an equilibrium, no prediction is possible
  explicit Steps(const Model& model, bool with_equilibrium = false,
                 const record::Channel& read = record::friction_torque);
};

/// Stages of a prediction. A changed parameter affects the first stage that uses the parameter, and
/// all later stages.
enum class Stage { entry, condition, lubricant, base, moment, reading };

/// Returns the first stage that uses the parameters of an effect (`effect`: index in
/// Model::effects) or of the base law (`effect` < 0).
[[nodiscard]] Stage first_stage(const Model& model, const Steps& steps, int effect);

/// Returns the inputs of friction laws and effects for one bearing, before any effect changes them.
/// `equilibrium` may be null.
[[nodiscard]] friction::BearingState<double> bearing_state(
    const Model& model, const bearing::OperatingPoint& point,
    const bearing::BearingEquilibrium* equilibrium);

/// Returns the condition of a bearing (extra load, tilt, ring growth, ball material): the condition
/// `given` after the effects of the model have changed it. `entered` is the bearing state before
/// these changes. The state may belong to the bearing of the model or to another bearing. If an
/// effect needs an unknown input, such as a column that the record lacks, the members of the
/// condition that this effect changes are not finite.
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given = {});
/// Returns the condition of a bearing like the function above, but does not compute the friction
/// power. `power` is the result of entered_power() [W]; unused if uses_power() is false.
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given, double power);

/// Returns true if an effect that changes the condition depends on the friction power.
[[nodiscard]] bool uses_power(const Model& model, const Steps& steps);
/// Returns the friction power of the base law [W] for the bearing state before any change by an
/// effect. If the law uses ball loads, the function first solves the ball equilibrium.
[[nodiscard]] double entered_power(const Model& model, friction::BearingState<double> entered,
                                   const bearing::OperatingPoint& point);

}  // namespace raceway::model
