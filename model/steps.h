#pragma once

#include <cstddef>
#include <vector>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Returns true if the law or an effect of the model uses ball loads or angles. Laws for the whole
/// bearing use neither ball loads nor ball angles. With such a law, and without effects that use
/// ball loads, a prediction needs no ball equilibrium.
[[nodiscard]] bool needs_equilibrium(const Model& model);

/// Effects of a model, grouped by the step of the prediction that they change. Create this object
/// once for many predictions.
struct Steps {
  /// Indices in Model::effects. `reading` contains the effects on the measured channel.
  std::vector<std::size_t> entry, condition, lubricant, moment, reading;
  bool equilibrium = false;  ///< true if an equilibrium of balls or rollers must be solved
  bool needs_balls = false;  ///< true if a prediction is impossible without an equilibrium
  explicit Steps(const Model& model, bool with_equilibrium = false,
                 const record::Channel& read = record::friction_torque);
};

/// Stages of a prediction. A changed parameter affects the first stage that uses the parameter, and
/// all later stages.
enum class Stage { entry, condition, lubricant, base, moment, reading };

/// Returns the first stage that a parameter of the base law (`effect` < 0) or of an effect affects.
[[nodiscard]] Stage first_stage(const Model& model, const Steps& steps, int effect);

/// Returns the inputs of friction laws and effects for one bearing, before any effect changes them.
/// `equilibrium` may be null.
[[nodiscard]] friction::BearingState<double> bearing_state(
    const Model& model, const bearing::OperatingPoint& point,
    const bearing::BearingEquilibrium* equilibrium);

/// Returns the condition of a bearing: `given` plus the changes by the effects of the model.
/// `entered` is the bearing state before these changes. Its bearing may differ from the bearing of
/// the model. The condition is not finite if an input is unknown.
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given = {});
/// Works like the function above if the friction power at the original load is already known:
/// `power` [W].
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given, double power);

/// Returns true if an effect on the condition uses the friction power of the base law at the
/// original load.
[[nodiscard]] bool uses_power(const Model& model, const Steps& steps);
/// Returns the friction power of the base law at the original load [W]. For the contact law, the
/// function first solves the equilibrium of the balls.
[[nodiscard]] double entered_power(const Model& model, friction::BearingState<double> entered,
                                   const bearing::OperatingPoint& point);

}  // namespace raceway::model
