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
/// Effects of the model act on every bearing as they do on a single one. What they change of the
/// condition enters the balance of the sets: ring growth shifts the grooves, other balls replace
/// the bearing (the preload at standstill stays). An extra load of theirs is seen by the friction
/// alone, and a tilt not at all by the balance; both are entered at the preload.
/// Throws std::invalid_argument for a model without shaft and for points that are not finite.
[[nodiscard]] std::vector<ShaftPrediction> predict_shaft(const Model& model,
                                                         std::span<const ShaftPoint> points);

/// Displacement of the model's shaft at rows of measured displacement [m], as
/// ShaftPrediction::displacement; NaN where the sets do not balance. The axial load of a row is the
/// external load.
///
/// What was recorded with a row stands in the place of what the model says: the preload as force at
/// standstill, ring temperatures. Balls, shaft and housing keep the temperatures of the model where
/// it has any; otherwise they follow the rings: balls their mean, the shaft the inner, the housing
/// the outer.
/// Throws std::invalid_argument for a model without shaft, and as add_expansion() does.
[[nodiscard]] std::vector<double> predict_displacement(const Model& model,
                                                       std::span<const Row> rows);

/// What is measured, at every row of the data: friction torque of the rig [N m] or displacement of
/// the shaft [m]; NaN where there is no balance. Throws as require_measured_subject().
[[nodiscard]] std::vector<double> predict_readings(const Model& model, const DataSet& data);

/// Throws std::invalid_argument unless the data are of what the model stands for: displacement of a
/// shaft, friction torque of a bearing on a rig.
void require_measured_subject(const Model& model, const DataSet& data);

/// The condition of the model's arrangement at a point, its temperatures included.
[[nodiscard]] bearing::ArrangementCondition shaft_condition(const Model& model,
                                                            const ShaftPoint& point);

}  // namespace raceway::fit
