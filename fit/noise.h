#pragma once

#include <string_view>
#include <vector>

#include "record/record.h"

namespace raceway::fit {

/// Source of the noise of readings.
enum class NoiseSource {
  none,        ///< the noise is unknown
  declared,    ///< standard deviations in the record
  regression,  ///< standard deviations from the regression that produced the readings
  repeats,     ///< scatter of rows with equal inputs
  neighbours   ///< scatter of readings that are neighbours in time
};

/// Returns the source as the JSON results state it: "none", "declared", "regression", "repeats",
/// "neighbours".
[[nodiscard]] std::string_view name(NoiseSource source);

/// Noise of the readings of one channel.
struct Noise {
  double rms = unset;  ///< RMS noise [SI]; NaN if unknown
  NoiseSource source = NoiseSource::none;
  /// Degrees of freedom of `repeats_rms`, also if the record declares standard deviations.
  int degrees_of_freedom = 0;
  double repeats_rms = unset;  ///< RMS scatter at equal inputs [SI]; NaN if no inputs repeat
};

/// Returns the noise of a measured channel. If every reading has a standard deviation, the noise is
/// the RMS of these standard deviations. Otherwise the noise is the scatter of the readings in rows
/// with equal inputs. The noise is unknown if this scatter is zero or has fewer than 3 degrees of
/// freedom. The misfit of a model is never used, because a missing effect would then appear as
/// noise.
[[nodiscard]] Noise estimate_noise(const record::Record& record, const record::Channel& measured);

/// Readings of one stop of the machine, for example from several measurements with a touch probe.
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
  double std = unset;  ///< pooled standard deviation of a single reading over all stops [SI]
  int degrees_of_freedom = 0;

  [[nodiscard]] bool known() const { return degrees_of_freedom > 0; }
};

/// Finds the stops of a record and the scatter of the readings within stops. A stop is a group of
/// readings of one run that follow each other quickly, with much longer breaks between groups than
/// within a group. A straight line is subtracted from groups of 4 or more readings, because the
/// readings may drift during the stop. The result is empty in these cases:
///   - A group has more than 30 readings.
///   - Fewer than two groups have two or more readings.
///   - The groups with two or more readings contain less than half of all readings.
///   - The scatter has fewer than 3 degrees of freedom.
[[nodiscard]] Repeatability repeatability(const record::Record& record,
                                          const record::Channel& measured);

/// Returns the standard deviation of single readings [SI], from repeatability() if repeatability()
/// finds stops. Without stops, the standard deviation comes from the distance of each reading from
/// the line between its neighbours in time, and is NaN in two cases: if fewer than 30 readings have
/// both neighbours in their run, or if the median time step exceeds 120 s. At longer time steps,
/// noise cannot be separated from motion of the machine.
[[nodiscard]] double noise_of_neighbours(const record::Record& record,
                                         const record::Channel& measured);

/// Returns an upper bound for the standard deviation of readings that are far apart in time [SI].
/// The bound comes from the distances of readings from the line between their neighbours in time.
/// The bound uses the lower quartile of these distances. If the machine was at rest for at least a
/// quarter of the time, motion at other times does not increase this quartile. The bound is NaN if
/// fewer than 10 readings have both neighbours in their run.
[[nodiscard]] double noise_of_calm_readings(const record::Record& record,
                                            const record::Channel& measured);

}  // namespace raceway::fit
