#pragma once

#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/steps.h"

namespace raceway::shaft {

using model::Model;
using model::Shaft;
using model::Steps;

/// Condition of the sets of a shaft at one operating point.
struct ShaftCondition {
  bearing::ArrangementCondition sets;
  /// Changes by effects for each bearing, front set first.
  std::vector<effects::Condition> bearings;
};

/// Mounts the bearing sets of a shaft and finds their operating condition, with the changes by
/// effects.
///
/// Effects on balls, fits and mounting act before the shaft first turns. Such effects belong to the
/// mounted state, in which the sets carry the preload of the model. A preload force keeps its value
/// with any interference fit. A preload offset is ground into the bearings before mounting, so an
/// interference fit adds to the offset. Ring growth by speed, heat and temperature shifts the
/// grooves from the mounted state.
class ShaftBalance {
 public:
  /// `preload` replaces the preload force of the model [N]. NaN keeps the force of the model.
  explicit ShaftBalance(double preload = unset) : preload_(preload) {}

  /// Mounts the sets with the parameter values of a model, unless they are already mounted with
  /// these values. Returns false if the sets cannot be mounted: a bearing has no free contact angle
  /// left, or Arrangement rejects a value.
  bool mount(const Model& model, const Steps& steps);
  /// Returns a number that changes whenever mount() changes the mounted sets.
  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] bool mounted() const { return arrangement_.has_value(); }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return *arrangement_; }

  /// Finds the condition at an operating point. The axial load of `point` is the external load on
  /// the shaft. Returns false if an effect gives no finite value. Throws std::invalid_argument like
  /// add_expansion().
  bool find_condition(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
                      const effects::Record& record,
                      const std::optional<bearing::SetTemperatures>& temperatures,
                      ShaftCondition& condition) const;

  /// Returns the shaft position at standstill under this load [m]; NaN if there is no equilibrium.
  [[nodiscard]] double standstill(double external_load,
                                  const bearing::EquilibriumOptions& options) const;

 private:
  double preload_;
  std::optional<bearing::Arrangement> arrangement_;  // empty if it cannot be mounted
  bearing::ArrangementDesign entered_;
  std::vector<effects::Condition> at_rest_;  // condition of every bearing as mounted
  int version_ = 0;
};

/// Returns the arrangement of a shaft after the effects of the model have changed balls, fits and
/// mounting. If the changed arrangement cannot be mounted, the original arrangement is returned.
[[nodiscard]] bearing::Arrangement mounted_arrangement(const Model& model);

/// Returns the temperatures of the sets of a shaft. Measured ring temperatures replace the ring
/// temperatures of the model. If a ring temperature is measured, a missing shaft temperature is the
/// temperature of the inner ring, and a missing housing temperature is the temperature of the outer
/// ring. Other missing temperatures of rings, shaft and housing are the mounting temperature. The
/// result is empty if neither measurement nor model gives a temperature.
[[nodiscard]] std::optional<bearing::SetTemperatures> set_temperatures(const Shaft& shaft,
                                                                       double inner_ring = unset,
                                                                       double outer_ring = unset);

}  // namespace raceway::shaft
