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

/// Friction of one bearing at one operating point, and what the rig reads of it. All numbers are
/// NaN where an input is not known, or where the point has no balance and an effect needs it;
/// `report` then says why. Where an effect has no number, the base moments have. A model that needs
/// no balls has its torque also without balance.
struct FrictionPrediction {
  double load = unset;  ///< load moment of the base law, at the load the bearing really sees [N m]
  double viscous = unset;  ///< viscous moment of the base law, as the film leaves it [N m]
  /// Added moment of each effect, in the order of the model [N m]; 0 for one that acts on
  /// condition, lubricant or reading, and shows in the other terms.
  std::vector<double> effects;
  /// Result of the contact law from which `load` and `viscous` come, with the effects on the film.
  std::optional<friction::contact::ContactResult> contacts;
  double torque = unset;      ///< sum of all these [N m]
  double power_loss = unset;  ///< torque times speed [W]
  double reading = unset;  ///< of the rig: torque of all its bearings, then the reading steps [N m]
  effects::Condition condition;  ///< changes of the entered condition by effects
  effects::Film film;            ///< viscosity and temperature of the film
  /// The bearing as the condition makes it; null where that is the one entered.
  std::shared_ptr<const bearing::Bearing> bearing;
  /// Balls in balance; null without a balance, or if it was neither requested nor needed.
  std::shared_ptr<const bearing::BearingEquilibrium> equilibrium;
  /// Rollers in balance, for a bearing with cylindrical rollers.
  std::shared_ptr<const bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;  ///< not_run where no equilibrium was needed

  [[nodiscard]] bool predicted() const;  ///< torque is a number
  /// Status of the point, for all commands: the outcome of the search for its balance, but
  /// `converged` only where the torque, its parts and the loss are finite; else `not_finite`.
  [[nodiscard]] bearing::SolveStatus status() const;
};

/// The ball bearing of a prediction: as the condition makes it, else as entered.
[[nodiscard]] inline const bearing::Bearing& bearing_of(const Model& model,
                                                        const FrictionPrediction& prediction) {
  return prediction.bearing ? *prediction.bearing : *model.bearing;
}

/// Names of the parts of a model's torque: parts of the base law, then the effects.
///   palmgren, skf: load, viscous        contact: rolling, sliding, hysteresis, drag
[[nodiscard]] std::vector<std::string> torque_parts(const Model& model);
/// Torque parts of a prediction [N m], in that order; NaN where there is none.
[[nodiscard]] std::vector<double> moments_of_parts(const Model& model,
                                                   const FrictionPrediction& prediction);

/// Contacts of every distinct ball of a converged prediction by the contact law, with the effects
/// on the film.
[[nodiscard]] std::vector<friction::contact::BallFriction> ball_contacts(
    const Model& model, const bearing::OperatingPoint& point, const FrictionPrediction& prediction);

/// Reason why a prediction has not converged, in words: "no_equilibrium" and the like, or the
/// effect without a finite moment.
[[nodiscard]] std::string why_not_converged(const Model& model,
                                            const FrictionPrediction& prediction);

/// Friction of one bearing [N m] on its way through four steps, at each of which effects may act:
///
///   condition    extra load, tilt, growth of rings, ball material: changes add up
///   -> ball equilibrium, where an effect needs it or `with_equilibrium` asks for it
///   lubricant    viscosity of the film and share of the viscous moment, in the order of the
///                catalogue
///   -> base law at the real load and the film's viscosity; Palmgren's with the entered bearing
///   moment       added moments, each from the base moments before this step
///   -> torque of all bearings of the rig
///   reading      added to the torque, each from that before this step
///
/// so the order of effects in the model changes nothing.
[[nodiscard]] FrictionPrediction predict_friction(const Model& model,
                                                  const bearing::OperatingPoint& point,
                                                  bool with_equilibrium = false,
                                                  const effects::Record& record = {});

/// Predicts many points, solved side by side and shared among threads: neither the number of
/// threads nor the other points change a digit. `records` may be empty. Throws
/// std::invalid_argument if the sizes differ.
void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium = false,
                   std::span<const effects::Record> records = {});

/// Friction of one bearing at every row of a record, in its order.
[[nodiscard]] std::vector<FrictionPrediction> predict_rows(const Model& model,
                                                           const record::Record& record);

/// Share of an added moment that falls to one bearing [1]: what drags on the rotor is there once
/// where the rotor coasts down (effects::Nature::drags_on_the_rotor), else once per bearing.
[[nodiscard]] double share_of_bearing(const effects::Description& effect, const Rig& rig);

/// Torque of all bearings of a rig, which turn on one shaft, M = bearings * M_bearing [N m]; the
/// steps of reading not included.
[[nodiscard]] double rig_torque(const Rig& rig, double bearing_torque);

}  // namespace raceway::model
