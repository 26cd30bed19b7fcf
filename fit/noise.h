#pragma once

#include <string_view>
#include <vector>

#include "record/record.h"

namespace raceway::fit {

/// Source of the noise of readings.
enum class NoiseSource {
  none,
  declared,
  regression,  ///< standard deviations from the regression that produced the readings
  repeats,
  neighbours  ///< scatter of readings that are neighbours in time
};

/// Returns the source as the JSON results state it: "none", "declared", "regression", "repeats",
/// "neighbours".
[[nodiscard]] std::string_view name(NoiseSource source);

/// Noise of the readings of one channel.
struct Noise {
  double rms = unset;  ///< RMS noise [SI]; NaN if unknown
  NoiseSource source = NoiseSource::none;
  /// Degrees of freedom of the scatter within repeats, even if the noise is declared.
  int degrees_of_freedom = 0;
  double repeats_rms = unset;  ///< RMS scatter within repeats [SI]; NaN without repeats
};

/// Returns the noise of a measured channel. If every reading has a standard deviation, the noise is
/// the RMS of these standard deviations. Otherwise it is the scatter within repeated rows, or
/// unknown if this scatter is zero or has fewer than 3 degrees of freedom. The misfit of a model is
/// never used, because missing physics would then appear as noise.
[[nodiscard]] Noise estimate_noise(const record::Record& record, const record::Channel& measured);

/// Readings of one stop of the machine, for example from several approaches of a probe.
struct Stop {
  double time = unset;  ///< time of the first reading [s]
  int readings = 0;
  double mean = unset;  ///< mean of the readings [SI]
  /// Standard deviation of one reading, from this stop only [SI]; NaN for a single reading.
  double std = unset;
};

/// Repeatability of a measured channel over all stops.
struct Repeatability {
  std::vector<Stop> stops{};
  double std = unset;  ///< standard deviation of one reading, from all stops together [SI]
  int degrees_of_freedom = 0;

  [[nodiscard]] bool known() const { return degrees_of_freedom > 0; }
};

/// Finds the stops of a record and the scatter of the readings within a stop. A stop is a group of
/// readings of one run. The breaks between groups are much longer than the time steps within a
/// group. A straight line is subtracted from groups of 4 or more readings, because the machine may
/// move during the stop. The result is empty if a group has more than 30 readings. The result is
/// also empty unless at least two groups have two or more readings, these groups contain at least
/// half of all readings, and the scatter has at least 3 degrees of freedom.
[[nodiscard]] Repeatability repeatability(const record::Record& record,
                                          const record::Channel& measured);

/// Returns the standard deviation of single readings [SI], from repeatability() if it finds stops.
/// Otherwise, the standard deviation comes from the distances of readings from the line between
/// their neighbours in time. In this case, the result is NaN if fewer than 30 readings have both
/// neighbours in their run, or if the median time step exceeds 120 s, because noise and real motion
/// could then not be separated.
[[nodiscard]] double noise_of_neighbours(const record::Record& record,
                                         const record::Channel& measured);

/// Returns an upper bound for the standard deviation of readings that are far apart in time [SI].
/// The bound uses the quarter of the readings closest to the line between their neighbours. If the
/// machine was at rest for a quarter of the time, this quarter shows only noise. The bound is NaN
/// if fewer than 10 readings have both neighbours in their run.
[[nodiscard]] double noise_of_calm_readings(const record::Record& record,
                                            const record::Channel& measured);

}  // namespace raceway::fit
