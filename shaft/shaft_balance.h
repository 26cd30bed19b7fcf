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

/// Finds the conditions of the sets of a shaft for their equilibrium, with the changes by effects.
///
/// Effects on balls, fits and mounting act before the shaft first turns. Such effects belong to the
/// mounted state, in which the sets carry the preload of the model. A preload force keeps its value
/// with any fit. A preload offset is ground into bearings before they are mounted, so a fit adds to
/// the offset. Growth by speed, heat and temperature shifts the grooves from the mounted state.
class ShaftBalance {
 public:
  /// `preload` replaces the preload force of the model [N]. NaN keeps the force of the model.
  explicit ShaftBalance(double preload = unset) : preload_(preload) {}

  /// Mounts the sets with the parameter values of a model, unless they are already mounted with
  /// these values. Returns false if they cannot be mounted: rings without a free contact angle, or
  /// values that no arrangement accepts.
  bool mount(const Model& model, const Steps& steps);
  /// Returns a number that changes whenever mount() changes anything.
  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] bool mounted() const { return arrangement_.has_value(); }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return *arrangement_; }

  /// Finds the condition at a point whose axial load is the external load. Returns false if an
  /// effect has no value there. Throws std::invalid_argument like add_expansion().
  bool find_condition(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
                      const effects::Record& record,
                      const std::optional<bearing::SetTemperatures>& temperatures,
                      ShaftCondition& condition) const;

  /// Returns the position of the mounted sets at standstill under this load; NaN if the load
  /// separates the sets.
  [[nodiscard]] double standstill(double external_load,
                                  const bearing::EquilibriumOptions& options) const;

 private:
  double preload_;
  std::optional<bearing::Arrangement> arrangement_;  // empty if it cannot be mounted
  bearing::ArrangementDesign entered_;
  std::vector<effects::Condition> at_rest_;  // condition of every bearing as mounted
  int version_ = 0;
};

/// Returns the arrangement of a shaft with the balls, fits and mounting from the effects of its
/// model. If the arrangement cannot be mounted, the original arrangement is returned.
[[nodiscard]] bearing::Arrangement mounted_arrangement(const Model& model);

/// Returns the temperatures of the sets of a shaft. Measured ring temperatures replace the ring
/// temperatures of the model. Unless the model gives the temperatures of shaft and housing, the
/// shaft has the measured temperature of the inner ring, and the housing has the measured
/// temperature of the outer ring. Other missing temperatures of rings, shaft and housing are the
/// mounting temperature. The result is empty if no temperature is known.
[[nodiscard]] std::optional<bearing::SetTemperatures> set_temperatures(const Shaft& shaft,
                                                                       double inner_ring = unset,
                                                                       double outer_ring = unset);

}  // namespace raceway::shaft
