#pragma once

#include <optional>
#include <span>
#include <string>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Estimated operation of a spindle before the first row of a run that began warm.
struct WarmStart {
  Inputs inputs{};          ///< constant inputs of the estimated operation
  double duration = unset;  ///< [s]
  /// Largest temperature rise of a thermometer above ambient in the first row [K].
  double rise = unset;
  bool zeroed = false;  ///< true if the displacement was set to zero in the first row

  /// Returns a sentence that begins like "the thermometers are up to 11 K above the room
  /// temperature in the first row: ...".
  [[nodiscard]] std::string statement() const;
};

/// Finds the operation before the first row of a run whose simulated temperatures agree best with
/// the thermometers in the first row. The result is empty unless at least two thermometers (or one,
/// if the model has only one) read more than 2 K above their temperatures in a simulated cold
/// start. The result is also empty if the record has no ambient temperature, or if the RMS
/// temperature error of the best operation is not below half of the RMS temperature error of a cold
/// start.
///
/// The candidate operations have a constant speed above 0: the speed of the first row, or the mean
/// or the highest speed of the run. They last 0.25, 0.5, 1, 2, 4 or 8 hours, with the other inputs
/// of the first row. `zeroed` is true if the absolute first reading of the displacement is less
/// than a quarter of the absolute displacement that the model predicts after the operation.
[[nodiscard]] std::optional<WarmStart> find_warm_start(const model::Model& model,
                                                       const record::Record& run,
                                                       std::span<const ProfileRow> profile);

/// Returns the temperatures of a spindle after the operation `past`, from which the run `profile`
/// starts.
[[nodiscard]] State state_after(Simulator& simulator, const WarmStart& past,
                                std::span<const ProfileRow> profile);

}  // namespace raceway::spindle
