#pragma once

#include <span>
#include <vector>

#include "fit/prediction.h"
#include "friction/heat.h"

namespace raceway::fit {

/// Where a shaft is asked.
struct ShaftPoint {
  double speed = 0.0;               ///< [rad/s]
  double external_load = 0.0;       ///< axial, positive towards the tool [N]
  double temperature = kelvin(40);  ///< of the lubricant [K]
};

/// A shaft at one point: its position, and the friction of every bearing under the load that the
/// sets make there. Numbers are NaN where the sets do not balance; `equilibrium.report` says why.
struct ShaftPrediction {
  bearing::ArrangementEquilibrium equilibrium;
  /// u: shaft position relative to standstill under the same external load, as mounted and at the
  /// mounting temperature, positive towards the tool [m].
  double displacement = unset;
  std::vector<FrictionPrediction> friction;  ///< of each bearing, front set first
  std::vector<friction::HeatSplit> heat;     ///< of each bearing
  double torque = unset;                     ///< sum over the bearings [N m]
  double power_loss = unset;                 ///< torque times speed [W]
};

/// Position, forces and friction of the model's shaft, each point from the one before it.
///
/// What effects change of the condition of a bearing enters the balance of the sets, as
/// ShaftBalance says, and the friction of each bearing in it; a tilt is seen by the friction alone.
/// All other steps act on every bearing as on a single one. What effects make of the reading of a
/// transducer is no part of the position: predict_displacement() adds it. Throws
/// std::invalid_argument for a model without shaft and for points that are not finite.
[[nodiscard]] std::vector<ShaftPrediction> predict_shaft(const Model& model,
                                                         std::span<const ShaftPoint> points);

/// What is measured, at every row of the data: friction torque of the rig [N m] or displacement of
/// the shaft [m]; NaN where there is no balance. Throws as require_measured_subject().
[[nodiscard]] std::vector<double> predict_readings(const Model& model, const DataSet& data);

/// Throws std::invalid_argument unless the data are of what the model stands for: displacement of a
/// shaft, friction torque of a bearing on a rig.
void require_measured_subject(const Model& model, const DataSet& data);

}  // namespace raceway::fit
