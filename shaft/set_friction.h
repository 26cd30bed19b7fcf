#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/row_predictor.h"

namespace raceway::shaft {

using model::Model;
using model::Steps;

/// The sets of a shaft in balance at one point.
struct SetState {
  const bearing::Arrangement& mounted;
  const bearing::ArrangementEquilibrium& equilibrium;
  const std::vector<effects::Condition>& bearings;  ///< changes by effects, front set first
  const std::optional<bearing::SetTemperatures>& temperatures;
  double speed = unset;        ///< [rad/s]
  double temperature = unset;  ///< of the lubricant [K]
  effects::Record record{};
};

/// Friction of every bearing in the sets of a shaft, from its own balls in their balance, under
/// their share of the load, with rings grown, warmed and shifted as they are there. Two parts still
/// treat a bearing by itself:
///
///   base law   Palmgren's and SKF's formulas know the entered bearing, its catalogue angle and
///              load rating, under the axial load that it carries in the set
///   a tilt     the sets are solved without one; a bearing that an effect tilts is solved alone at
///              this load, with the free contact angle that growth and temperatures give it
///
/// A bearing that has lost its inner contacts carries nothing and has the viscous moment of the
/// base law, and the share of the effects from balls on the outer race alone. All other steps act
/// on every bearing as on a single one; effects on the reading are left out.
class SetFriction {
 public:
  /// Throws std::invalid_argument for a model without shaft.
  explicit SetFriction(const Model& model);

  [[nodiscard]] std::size_t bearings() const { return models_.size(); }
  /// The model of a single bearing, on a rig with as many bearings as the sets have: what drags on
  /// the rotor is there once.
  [[nodiscard]] const Model& model(std::size_t i) const { return models_[i]; }
  /// Steps of a bearing: the balance of the sets finds the conditions.
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Takes over the numbers of a model with the same effects.
  void take(const Model& model);

  /// Bearing i as it stands in the sets. With `steps.equilibrium` its balls are looked at.
  [[nodiscard]] model::RowPredictor row(std::size_t i, const SetState& sets,
                                        const Steps& steps) const;
  /// A bearing of which nothing is known: it has no reading.
  [[nodiscard]] model::RowPredictor nothing(std::size_t i) const;

 private:
  std::vector<Model> models_;
  std::vector<std::shared_ptr<const bearing::Bearing>> entered_;
  double mounting_temperature_;
  Steps steps_;
};

}  // namespace raceway::shaft
