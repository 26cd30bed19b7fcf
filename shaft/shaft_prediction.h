#pragma once

#include <span>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "friction/heat.h"
#include "model/prediction.h"

namespace raceway::shaft {

using model::Model;

/// Operating point of a shaft.
struct ShaftPoint {
  double speed = 0.0;               ///< [rad/s]
  double external_load = 0.0;       ///< axial load, positive towards the tool [N]
  double temperature = kelvin(40);  ///< temperature of the lubricant [K]
};

/// Position of a shaft and friction of all its bearings at one operating point. If the bearing sets
/// have no equilibrium, all numbers are NaN and all lists are empty, and `equilibrium.report` gives
/// the reason.
struct ShaftPrediction {
  bearing::ArrangementEquilibrium equilibrium;
  /// Shaft position minus the position of the mounted shaft at standstill and mounting temperature,
  /// under the same external load; positive towards the tool [m].
  double displacement = unset;
  std::vector<model::FrictionPrediction> friction;  ///< friction of each bearing, front set first
  std::vector<friction::HeatSplit> heat;  ///< heat of each bearing, split between its rings
  double torque = unset;                  ///< friction torque, summed over all bearings [N m]
  double power_loss = unset;              ///< torque times speed [W]

  /// Returns the status that all commands report for this point: the status of the equilibrium, or
  /// `not_finite` if the equilibrium converged but position, torque, power loss or the friction of
  /// a bearing is not finite.
  [[nodiscard]] bearing::SolveStatus status() const;
};

/// Predicts position, forces and friction of a shaft at each point. For each point, the solver
/// starts from the solution of the last converged point before this point.
///
/// The equilibrium includes the effects that change the condition of a bearing, such as ring growth
/// (see ShaftBalance). SetFriction computes the friction of each bearing. Position and torque do
/// not include effects on sensor readings. predict_displacement() and predict_torque() include
/// these effects. Throws std::invalid_argument for a model without a shaft and for points that are
/// not finite.
[[nodiscard]] std::vector<ShaftPrediction> predict_shaft(const Model& model,
                                                         std::span<const ShaftPoint> points);

}  // namespace raceway::shaft
