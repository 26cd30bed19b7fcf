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
  bool zeroed = false;  ///< true if the displacement sensor was set to zero at the first row

  /// Returns a sentence about the warm start, such as "the thermometers are up to 11 K above the
  /// room temperature in the first row: ...".
  [[nodiscard]] std::string statement() const;
};

/// Estimates the operation before the first row of a run. The result is the operation whose
/// simulated temperatures agree best with the thermometers in the first row.
///
/// A result requires an ambient temperature in the record. At least two thermometers, or the only
/// thermometer of the model, must read more than 2 K above their temperatures in a simulated cold
/// start. The RMS temperature error of the best operation must be below half of the RMS temperature
/// error of a cold start. If one of these conditions is not satisfied, the result is empty.
///
/// The candidate operations have a constant speed above 0: the speed of the first row, or the mean
/// or the highest speed of the run. Each of these speeds is combined with durations of 0.25, 0.5,
/// 1, 2, 4 and 8 hours. All other inputs are the inputs of the first row. WarmStart::zeroed is true
/// if the magnitude of the first displacement reading is less than a quarter of the displacement
/// that the model predicts after the operation.
[[nodiscard]] std::optional<WarmStart> find_warm_start(const model::Model& model,
                                                       const record::Record& run,
                                                       std::span<const ProfileRow> profile);

/// Returns the temperatures of a spindle after the operation `past`. The run `profile` starts from
/// these temperatures.
[[nodiscard]] State state_after(Simulator& simulator, const WarmStart& past,
                                std::span<const ProfileRow> profile);

}  // namespace raceway::spindle
