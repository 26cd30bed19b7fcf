#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/row_predictor.h"

namespace raceway::shaft {

using model::Model;
using model::Steps;

/// Equilibrium and operating condition of the sets of a shaft, as input of SetFriction.
struct SetState {
  const bearing::Arrangement& mounted;
  const bearing::ArrangementEquilibrium& equilibrium;
  /// Changes by effects for each bearing, front set first.
  const std::vector<effects::Condition>& bearings;
  const std::optional<bearing::SetTemperatures>& temperatures;
  double speed = unset;        ///< [rad/s]
  double temperature = unset;  ///< temperature of the lubricant [K]
  effects::Record record{};
};

/// Calculates the friction of each bearing in the sets of a shaft. The friction follows from the
/// balls in the equilibrium of the sets, which includes growth, temperatures and shifts of the
/// rings. Two calculations still treat a bearing alone:
///
///   base law   Palmgren's and SKF's formulas use the entered geometry with its catalogue angle
///              and load rating, and the axial load of the bearing in the set
///   tilt       the sets are solved without a tilt. A bearing that an effect tilts is solved alone
///              at its load in the set, with the free contact angle from growth and temperatures
///
/// A bearing without inner contacts carries no load. Such a bearing has the viscous moment of the
/// base law and the moments that effects give for balls that touch only the outer race. All other
/// calculations are the same as for a single bearing. Effects on the torque reading are not
/// included.
class SetFriction {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit SetFriction(const Model& model);

  [[nodiscard]] std::size_t bearings() const { return models_.size(); }
  /// Returns the model of bearing i. In this model, the rig has as many bearings as the sets, so
  /// each bearing has an equal share of the drag on the rotor. The sum over all bearings includes
  /// the drag once.
  [[nodiscard]] const Model& model(std::size_t i) const { return models_[i]; }
  /// Returns the calculation steps of each bearing. The steps contain no effects on the condition
  /// of a bearing, because the equilibrium of the sets already includes these effects.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Copies the parameter values from a model with the same effects.
  void take(const Model& model);

  /// Returns the predictor of bearing i for these sets. The predictor has the equilibrium of the
  /// balls if `steps.equilibrium` is true.
  [[nodiscard]] model::RowPredictor row(std::size_t i, const SetState& sets,
                                        const Steps& steps) const;
  /// Returns a predictor of bearing i that predicts NaN, for a row without equilibrium.
  [[nodiscard]] model::RowPredictor nothing(std::size_t i) const;

 private:
  std::vector<Model> models_;
  std::vector<std::shared_ptr<const bearing::Bearing>> entered_;
  double mounting_temperature_;
  Steps steps_;
};

}  // namespace raceway::shaft
