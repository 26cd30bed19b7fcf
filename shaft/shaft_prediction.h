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
  std::vector<model::FrictionPrediction> friction;  ///< of each bearing, front set first
  std::vector<friction::HeatSplit> heat;            ///< of each bearing
  double torque = unset;                            ///< sum over the bearings [N m]
  double power_loss = unset;                        ///< torque times speed [W]

  /// Status of the point, for every command alike: the status of the balance of the sets, and
  /// `converged` only if position, torques and losses are finite; else `not_finite`.
  [[nodiscard]] bearing::SolveStatus status() const;
};

/// Position, forces and friction of the model's shaft, each point from the one before it.
///
/// Changes of the condition of a bearing by effects enter the balance of the sets, as ShaftBalance
/// says. The friction of each bearing comes from its own balls in this balance, under their share
/// of the load, with rings grown, warmed and shifted as they are there. Two parts still treat a
/// bearing by itself:
///
///   base law   Palmgren's and SKF's formulas know the entered bearing, its catalogue angle and
///              load rating, under the axial load that it carries in the set
///   a tilt     the sets are solved without one; a bearing that an effect tilts is solved alone at
///              this load, with the free contact angle that growth and temperatures give it
///
/// A bearing that has lost its inner contacts carries nothing and has the viscous moment of the
/// base law, and the share of the effects from balls on the outer race alone. All other steps act
/// on every bearing as on a single one. Effects on the reading of a transducer are no part of the
/// position: predict_displacement() adds them. Throws std::invalid_argument for a model without
/// shaft and for points that are not finite.
[[nodiscard]] std::vector<ShaftPrediction> predict_shaft(const Model& model,
                                                         std::span<const ShaftPoint> points);

}  // namespace raceway::shaft
