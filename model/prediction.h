#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "effects/effect.h"
#include "friction/contact/contact_law.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::model {

/// Friction of one bearing at one operating point, and the reading of the rig. A value is NaN if an
/// input is unknown. A value is also NaN if the friction law or an effect needs the ball
/// equilibrium, and the solver found no equilibrium (see `report`). If only the moment of an effect
/// cannot be computed, `load` and `viscous` are still valid. If neither the law nor an effect needs
/// the ball loads, the torque is valid even without an equilibrium.
struct FrictionPrediction {
  double load = unset;     ///< load moment of the base law, with the extra load from effects [N m]
  double viscous = unset;  ///< viscous moment of the base law, with the effects on the film [N m]
  /// Moment of each effect, in the order of the model [N m]. The moment is 0 for an effect that
  /// changes the condition, the lubricant or the reading, because `load`, `viscous` or `reading`
  /// contains its influence.
  std::vector<double> effects;
  /// Result of the contact law from which `load` and `viscous` are calculated, including effects on
  /// the film; empty for all other laws.
  std::optional<friction::contact::ContactResult> contacts;
  double torque = unset;      ///< sum of all moments [N m]
  double power_loss = unset;  ///< torque times speed [W]
  /// Reading of the rig: torque of all bearings on the rig, changed by the effects on the reading
  /// [N m].
  double reading = unset;
  effects::Condition condition;  ///< extra load, tilt, ring growth and ball material from effects
  effects::Film film;            ///< viscosity and temperature of the film
  /// Bearing with the changes of `condition`; null if the bearing is unchanged.
  std::shared_ptr<const bearing::Bearing> bearing;
  /// Equilibrium of the balls; null if it was neither needed nor requested, or if the solver found
  /// none.
  std::shared_ptr<const bearing::BearingEquilibrium> equilibrium;
  /// Equilibrium of the rollers of a cylindrical roller bearing; otherwise null.
  std::shared_ptr<const bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;  ///< report of the solver; `not_run` if no equilibrium was needed

  [[nodiscard]] bool predicted() const;  ///< true if the torque is finite
  /// Returns the status of the prediction. If the equilibrium solver failed, the result is the
  /// status of the solver. Otherwise, the result is `not_finite` if a moment or the power loss is
  /// not finite, and `converged` if all are finite.
  [[nodiscard]] bearing::SolveStatus status() const;
};

/// Returns the ball bearing of a prediction, with the changes of its condition.
[[nodiscard]] inline const bearing::Bearing& bearing_of(const Model& model,
                                                        const FrictionPrediction& prediction) {
  return prediction.bearing ? *prediction.bearing : *model.bearing;
}

/// Returns the names of the terms of a torque: terms of the base law, then the effects.
///   contact: rolling, sliding, hysteresis, drag     table: table
///   all other laws: load, viscous
[[nodiscard]] std::vector<std::string> torque_parts(const Model& model);
/// Returns the terms of the torque of a prediction, in the order of torque_parts() [N m]; NaN for a
/// term without a value.
[[nodiscard]] std::vector<double> moments_of_parts(const Model& model,
                                                   const FrictionPrediction& prediction);

/// Returns the contact friction of the balls, including effects on the film. `prediction` must be a
/// converged prediction by the contact law. If several balls have equal loads, the result contains
/// only one of them.
[[nodiscard]] std::vector<friction::contact::BallFriction> ball_contacts(
    const Model& model, const bearing::OperatingPoint& point, const FrictionPrediction& prediction);

/// Returns the status of a prediction that has not converged, such as "no_equilibrium". If only the
/// moment of an effect is not finite, the text also names this effect.
[[nodiscard]] std::string why_not_converged(const Model& model,
                                            const FrictionPrediction& prediction);

/// Predicts the friction of one bearing [N m] in steps. Effects can change the result of each step:
///
///   condition    extra load, tilt, growth of rings, ball material: sum of the effects' changes
///   -> ball equilibrium, if the law, an effect or `with_equilibrium` requires it
///   lubricant    viscosity of the film and factor on the viscous moment, in the order of the
///                catalogue
///   -> base law at the changed load and the film's viscosity. The contact law uses the changed
///      bearing, all other laws use the original bearing
///   moment       moments of the effects, each computed from the moments of the base law
///   -> torque of all bearings of the rig
///   reading      changes of the reading, each computed from the torque of all bearings
///
/// The order of effects in the model therefore has no influence on the prediction.
[[nodiscard]] FrictionPrediction predict_friction(const Model& model,
                                                  const bearing::OperatingPoint& point,
                                                  bool with_equilibrium = false,
                                                  const effects::Record& record = {});

/// Predicts many operating points in parallel. The result of a point does not depend on the other
/// points or on the number of threads, to the last digit. `records` contains the recorded inputs of
/// effects for each point, or is empty. Throws std::invalid_argument if the spans have different
/// lengths.
void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium = false,
                   std::span<const effects::Record> records = {});

/// Returns the friction of one bearing at every row of a record, in the order of the rows.
[[nodiscard]] std::vector<FrictionPrediction> predict_rows(const Model& model,
                                                           const record::Record& record);

/// Returns the share of an effect's moment that belongs to each bearing [1]. The drag on the rotor
/// of a coast-down rig (effects::Nature::drags_on_the_rotor) occurs once per rig, so the share is
/// 1/`rig.bearings`. For every other effect, the share is 1.
[[nodiscard]] double share_of_bearing(const effects::Description& effect, const Rig& rig);

/// Returns the torque of all bearings of a rig, `rig.bearings` * `bearing_torque` [N m]. Effects on
/// the reading are not included.
[[nodiscard]] double rig_torque(const Rig& rig, double bearing_torque);

}  // namespace raceway::model
