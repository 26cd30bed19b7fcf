#pragma once

#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/steps.h"

namespace raceway::shaft {

using model::Model;
using model::Shaft;
using model::Steps;

/// Condition of the sets of a shaft at one point.
struct ShaftCondition {
  bearing::ArrangementCondition sets;
  std::vector<effects::Condition> bearings;  ///< changes by effects, front set first
};

/// The sets of a model's shaft, with the changes of its effects.
///
/// Balls, fits and mounting are there before the shaft first turns: they belong to the mounted
/// state, in which the sets carry the preload of the model. A force of preload stays what it is,
/// whatever is mounted; an offset is ground into bearings that are not on the shaft yet, so that a
/// fit adds to it. Growth that comes with speed, heat and temperature shifts the grooves from
/// there.
class ShaftBalance {
 public:
  /// Uses another force of preload than the model's [N]; NaN: the model's.
  explicit ShaftBalance(double preload = unset) : preload_(preload) {}

  /// Mounts the sets with the parameter values of a model, unless that is how they are. False where
  /// they cannot be: rings without free contact angle, values that no arrangement has.
  bool mount(const Model& model, const Steps& steps);
  /// Another number whenever mount() has changed anything.
  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] bool mounted() const { return arrangement_.has_value(); }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return *arrangement_; }

  /// The condition at a point, whose axial load is the external one. False where an effect has no
  /// number there. Throws std::invalid_argument as add_expansion() does.
  bool find_condition(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
                      const effects::Record& record,
                      const std::optional<bearing::SetTemperatures>& temperatures,
                      ShaftCondition& condition) const;

  /// Position at standstill under this load, as mounted; NaN where the load takes the sets apart.
  [[nodiscard]] double standstill(double external_load,
                                  const bearing::EquilibriumOptions& options) const;

 private:
  double preload_;
  std::optional<bearing::Arrangement> arrangement_;  // nothing where it cannot be mounted
  bearing::ArrangementDesign entered_;
  std::vector<effects::Condition> at_rest_;  // of every bearing, as mounted
  int version_ = 0;
};

/// The arrangement of a model's shaft with the balls, fits and mounting that its effects put in; as
/// entered where it cannot be mounted so.
[[nodiscard]] bearing::Arrangement mounted_arrangement(const Model& model);

/// Temperatures of a shaft's sets: rings that were measured in the place of the model's. Shaft and
/// housing follow measured rings where the model leaves them open; what else is not given stays at
/// the mounting temperature. Nothing where there is no temperature at all.
[[nodiscard]] std::optional<bearing::SetTemperatures> set_temperatures(const Shaft& shaft,
                                                                       double inner_ring = unset,
                                                                       double outer_ring = unset);

}  // namespace raceway::shaft
