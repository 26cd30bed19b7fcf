#pragma once

#include <optional>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "model/steps.h"

namespace raceway::shaft {

using model::Model;
using model::Shaft;
using model::Steps;

/// Operating condition of the bearing sets of a shaft: speed, axial load, thermal and centrifugal
/// growth, and the changes that effects make to the bearings.
struct ShaftCondition {
  bearing::ArrangementCondition sets;
  /// Changes that the effects of the model make to each bearing, front set first.
  std::vector<effects::Condition> bearings;
};

/// Mounts the bearing sets of a shaft and finds their operating condition, including the effects of
/// the model.
///
/// Effects that change balls, interference fits or mounting act on the mounted state, before the
/// shaft turns for the first time. In this state, the sets have the preload of the model. A preload
/// given as a force does not change with the interference fit. A preload given as an offset is
/// ground into the bearings before mounting, so an interference fit increases the offset. Ring
/// growth by speed and temperature shifts the grooves relative to the mounted state.
class ShaftBalance {
 public:
  /// `preload` is a preload force [N] that is used instead of the preload of the model. If it is
  /// NaN, the preload of the model is used.
  explicit ShaftBalance(double preload = unset) : preload_(preload) {}

  /// Mounts the sets with the parameter values of `model`, unless the sets are already mounted with
  /// these values. Returns false if the sets cannot be mounted: the effects make a bearing
  /// impossible (for example, an interference fit reduces the free contact angle to zero), or
  /// Arrangement rejects a value.
  bool mount(const Model& model, const Steps& steps);
  /// Returns a number that changes whenever mount() changes the mounted sets.
  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] bool mounted() const { return arrangement_.has_value(); }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return *arrangement_; }

  /// Writes the condition of the sets at an operating point to `condition`. The axial load of
  /// `point` is the external load on the shaft. Returns false if an effect gives no finite value.
  /// Throws std::invalid_argument in the same cases as add_expansion().
  bool find_condition(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
                      const effects::Record& record,
                      const std::optional<bearing::SetTemperatures>& temperatures,
                      ShaftCondition& condition) const;

  /// Returns the axial position of the shaft at standstill under an external axial load [m]; NaN if
  /// there is no equilibrium.
  [[nodiscard]] double standstill(double external_load,
                                  const bearing::EquilibriumOptions& options) const;

 private:
  double preload_;
  std::optional<bearing::Arrangement> arrangement_;  // empty if the sets cannot be mounted
  bearing::ArrangementDesign entered_;
  std::vector<effects::Condition> at_rest_;  // condition of every bearing in the mounted state
  int version_ = 0;
};

/// Returns the arrangement of a shaft after the effects of the model have changed balls, fits and
/// mounting. If the changed arrangement cannot be mounted, the original arrangement is returned.
[[nodiscard]] bearing::Arrangement mounted_arrangement(const Model& model);

/// Returns the temperatures of the sets of a shaft. Measured ring temperatures replace the ring
/// temperatures of the model. If a ring temperature is measured, a missing shaft temperature is the
/// temperature of the inner ring, and a missing housing temperature is the temperature of the outer
/// ring. All other missing temperatures of rings, shaft and housing equal the mounting temperature.
/// The result is empty if neither measurement nor model gives a temperature.
[[nodiscard]] std::optional<bearing::SetTemperatures> set_temperatures(const Shaft& shaft,
                                                                       double inner_ring = unset,
                                                                       double outer_ring = unset);

}  // namespace raceway::shaft
