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
  /// Changes that the effects of the model make to each bearing, front set first.
  const std::vector<effects::Condition>& bearings;
  const std::optional<bearing::SetTemperatures>& temperatures;
  double speed = unset;        ///< [rad/s]
  double temperature = unset;  ///< temperature of the lubricant [K]
  effects::Record record{};
};

/// Calculates the friction of each bearing in the sets of a shaft. The friction follows from the
/// loads and contact angles of the balls in the equilibrium of the sets. This equilibrium includes
/// growth, temperatures and shifts of the rings. Two calculations treat a bearing alone, without
/// the other bearings:
///
///   base law   Palmgren's and SKF's formulas use the geometry of the model file (nominal contact
///              angle, load rating), and the axial load of the bearing in the set
///   tilt       the equilibrium of the sets does not include tilt. If an effect tilts a bearing,
///              this bearing is solved alone, at its load in the set and with the free contact
///              angle after ring growth by speed and temperature
///
/// A bearing without inner contacts carries no load. The friction of such a bearing is the viscous
/// moment of the base law, plus the moments that effects give for balls without inner contact.
/// SetFriction does not include effects on the torque reading.
class SetFriction {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit SetFriction(const Model& model);

  [[nodiscard]] std::size_t bearings() const { return models_.size(); }
  /// Returns the model of bearing i. In this model, each bearing has an equal share of the drag on
  /// the rotor, so the sum over all bearings includes the drag once.
  [[nodiscard]] const Model& model(std::size_t i) const { return models_[i]; }
  /// Returns the calculation steps of each bearing. The steps contain no effects on the condition
  /// of a bearing, because the equilibrium of the sets already includes these effects.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Copies the parameter values from a model with the same effects.
  void take(const Model& model);

  /// Returns the friction predictor of bearing i for the state `sets`. The predictor contains the
  /// equilibrium of the balls if `steps.equilibrium` is true.
  [[nodiscard]] model::RowPredictor row(std::size_t i, const SetState& sets,
                                        const Steps& steps) const;
  /// Returns a predictor for a row without equilibrium. All its predictions are NaN.
  [[nodiscard]] model::RowPredictor nothing(std::size_t i) const;

 private:
  std::vector<Model> models_;
  std::vector<std::shared_ptr<const bearing::Bearing>> entered_;
  double mounting_temperature_;
  Steps steps_;
};

}  // namespace raceway::shaft
