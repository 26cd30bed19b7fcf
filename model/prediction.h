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
/// input is unknown, or if an effect needs the ball equilibrium and the solver found none (see
/// `report`). If only an effect has no value, `load` and `viscous` are still valid. A model that
/// does not need the ball loads gives a torque even without an equilibrium.
struct FrictionPrediction {
  double load = unset;     ///< load moment of the base law at the actual load of the bearing [N m]
  double viscous = unset;  ///< viscous moment of the base law, with the effects on the film [N m]
  /// Moment of each effect, in the order of the model [N m]. The moment is 0 for an effect that
  /// changes the condition, the lubricant or the reading; `load`, `viscous` or `reading` contains
  /// the influence of such an effect.
  std::vector<double> effects;
  /// Result of the contact law for `load` and `viscous`, including effects on the film.
  std::optional<friction::contact::ContactResult> contacts;
  double torque = unset;      ///< sum of all moments [N m]
  double power_loss = unset;  ///< torque times speed [W]
  /// reading of the rig: torque of all its bearings, changed by the effects on the reading [N m]
  double reading = unset;
  effects::Condition condition;  ///< extra load, tilt, ring growth and ball material from effects
  effects::Film film;            ///< viscosity and temperature of the film
  /// Bearing with the changes of `condition`; null if the bearing is unchanged.
  std::shared_ptr<const bearing::Bearing> bearing;
  /// Balls in equilibrium; null without an equilibrium, or if it was neither requested nor needed.
  std::shared_ptr<const bearing::BearingEquilibrium> equilibrium;
  /// Rollers in equilibrium, for a cylindrical roller bearing.
  std::shared_ptr<const bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;  ///< not_run if no equilibrium was needed

  [[nodiscard]] bool predicted() const;  ///< true if the torque is finite
  /// Returns the status of the point, as all commands print it: the status of the equilibrium solve
  /// if the solve failed. If the solve converged or was not needed, the status is `converged`, or
  /// `not_finite` if a moment or the power loss is not finite.
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

/// Returns the contact friction of the balls in a converged prediction by the contact law,
/// including effects on the film. Balls with equal loads occur once.
[[nodiscard]] std::vector<friction::contact::BallFriction> ball_contacts(
    const Model& model, const bearing::OperatingPoint& point, const FrictionPrediction& prediction);

/// Returns the status of a prediction that has not converged, such as "no_equilibrium". If only an
/// effect has no finite moment, the text also names this effect.
[[nodiscard]] std::string why_not_converged(const Model& model,
                                            const FrictionPrediction& prediction);

/// Predicts the friction of one bearing [N m] in steps, each of which effects can change:
///
///   condition    extra load, tilt, growth of rings, ball material: sum of the changes by effects
///   -> ball equilibrium, if an effect needs it or `with_equilibrium` requests it
///   lubricant    viscosity of the film and factor on the viscous moment, in the order of the
///                catalogue
///   -> base law at the actual load and the film's viscosity; palmgren: with the original bearing
///   moment       added moments, each computed from the base moments
///   -> torque of all bearings of the rig
///   reading      changes of the reading, each computed from the torque before this step
///
/// The order of effects in the model therefore has no influence on the prediction.
[[nodiscard]] FrictionPrediction predict_friction(const Model& model,
                                                  const bearing::OperatingPoint& point,
                                                  bool with_equilibrium = false,
                                                  const effects::Record& record = {});

/// Predicts many points in parallel, in SIMD lanes and on several threads. The result of a point
/// does not depend on the other points or on the number of threads, to the last digit. `records`
/// may be empty. Throws std::invalid_argument if the sizes differ.
void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium = false,
                   std::span<const effects::Record> records = {});

/// Returns the friction of one bearing at every row of a record, in the order of the rows.
[[nodiscard]] std::vector<FrictionPrediction> predict_rows(const Model& model,
                                                           const record::Record& record);

/// Returns the share of the moment of an effect that is added for each bearing [1]. The share is
/// 1/bearings for drag on the rotor of a coast-down rig (effects::Nature::drags_on_the_rotor), and
/// 1 for every other effect.
[[nodiscard]] double share_of_bearing(const effects::Description& effect, const Rig& rig);

/// Returns the torque of all bearings of a rig on one shaft, M = bearings * M_bearing [N m],
/// without the effects on the reading.
[[nodiscard]] double rig_torque(const Rig& rig, double bearing_torque);

}  // namespace raceway::model
