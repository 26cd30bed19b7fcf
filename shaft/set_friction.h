#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/row_predictor.h"

namespace raceway::shaft {

using model::Model;
using model::Steps;

/// State of the sets of a shaft at one point.
struct SetState {
  const bearing::Arrangement& mounted;
  const bearing::ArrangementEquilibrium& equilibrium;
  const std::vector<effects::Condition>& bearings;  ///< changes by effects, front set first
  const std::optional<bearing::SetTemperatures>& temperatures;
  double speed = unset;        ///< [rad/s]
  double temperature = unset;  ///< temperature of the lubricant [K]
  effects::Record record{};
};

/// Calculates the friction of each bearing in the sets of a shaft. The friction comes from the
/// balls of the bearing in the equilibrium of the sets, with their share of the load and with rings
/// that have grown, warmed and shifted. Two parts still treat a bearing on its own:
///
///   base law   Palmgren's and SKF's formulas use the bearing as entered, its catalogue angle and
///              load rating, with the axial load that it carries in the set
///   a tilt     the sets are solved without a tilt. A bearing that an effect tilts is solved alone
///              at its load in the set, with the free contact angle from growth and temperatures
///
/// A bearing without inner contacts carries no load. Such a bearing has the viscous moment of the
/// base law and the moments that effects give for balls that touch only the outer race. All other
/// steps are the same as for a single bearing. Effects on the reading are not included.
class SetFriction {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit SetFriction(const Model& model);

  [[nodiscard]] std::size_t bearings() const { return models_.size(); }
  /// Returns the model of one bearing, on a rig with as many bearings as the sets have. Drag on the
  /// rotor is therefore included once.
  [[nodiscard]] const Model& model(std::size_t i) const { return models_[i]; }
  /// Returns the steps of a bearing. These steps contain no conditions, because the equilibrium of
  /// the sets gives the conditions.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Sets the parameter values of a model with the same effects.
  void take(const Model& model);

  /// Returns the predictor of bearing i in this state of the sets, with the balls if
  /// `steps.equilibrium` is true.
  [[nodiscard]] model::RowPredictor row(std::size_t i, const SetState& sets,
                                        const Steps& steps) const;
  /// Returns a predictor of bearing i for an unknown speed and load. The predictor predicts NaN.
  [[nodiscard]] model::RowPredictor nothing(std::size_t i) const;

 private:
  std::vector<Model> models_;
  std::vector<std::shared_ptr<const bearing::Bearing>> entered_;
  double mounting_temperature_;
  Steps steps_;
};

}  // namespace raceway::shaft
