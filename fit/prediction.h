#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fit/data_set.h"
#include "fit/model.h"

namespace raceway::fit {

/// Friction of one bearing at one operating point. All numbers are NaN where an input is not known,
/// or where the point has no balance and an effect needs it; `report` then says why. A model that
/// needs no balls has its torque also where they find no balance.
struct FrictionPrediction {
  double load = unset;          ///< load moment of the base law [N m]
  double viscous = unset;       ///< viscous moment of the base law [N m]
  std::vector<double> effects;  ///< added moment of each effect, in the order of the model [N m]
  double torque = unset;        ///< sum of all these [N m]
  double power_loss = unset;    ///< torque times speed [W]
  /// Balls in balance; null where nobody asked for it and nothing needed it.
  std::shared_ptr<const bearing::BearingEquilibrium> equilibrium;
  bearing::SolveReport report;  ///< not_run where no equilibrium was needed

  [[nodiscard]] bool predicted() const;  ///< torque is a number
};

/// True if an effect of the model uses ball loads or angles. The base laws do not, so a bearing
/// whose load is only assumed can be compared without a solve.
[[nodiscard]] bool needs_equilibrium(const Model& model);

/// Friction of one bearing [N m]: base law plus effects, at the viscosity of the point's
/// temperature. The equilibrium is solved where the model needs it, or `with_equilibrium` asks for
/// it.
[[nodiscard]] FrictionPrediction predict_friction(const Model& model,
                                                  const bearing::OperatingPoint& point,
                                                  bool with_equilibrium = false);

/// The same for many points, shared among threads in fixed chunks with a warm start inside a chunk:
/// the number of threads changes no digit. Throws std::invalid_argument if the sizes differ.
void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium = false);

/// Friction of one bearing at every row of a data set, in its order.
[[nodiscard]] std::vector<FrictionPrediction> predict_rows(const Model& model, const DataSet& data);

/// What the rig reads: all its bearings turn on one shaft, M_rig = bearings * M [N m].
[[nodiscard]] double rig_torque(const Rig& rig, double bearing_torque);

/// The state of one bearing that friction laws and effects look at; `equilibrium` may be null.
[[nodiscard]] friction::BearingState<double> bearing_state(
    const Model& model, const bearing::OperatingPoint& point,
    const bearing::BearingEquilibrium* equilibrium);

}  // namespace raceway::fit
