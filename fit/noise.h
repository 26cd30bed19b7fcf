#pragma once

#include <string_view>
#include <vector>

#include "record/record.h"

namespace raceway::fit {

/// Source of the standard deviations of readings.
enum class NoiseSource {
  none,
  declared,
  regression,  ///< the regression that produced the readings
  repeats,
  neighbours  ///< neighbouring readings in time
};

/// Returns the source as the JSON results state it: "none", "declared", "regression", "repeats",
/// "neighbours".
[[nodiscard]] std::string_view name(NoiseSource source);

/// Noise of the readings of one channel.
struct Noise {
  double rms = unset;  ///< rms noise [SI]; NaN if unknown
  NoiseSource source = NoiseSource::none;
  int degrees_of_freedom = 0;  ///< degrees of freedom of the repeats, even if the noise is declared
  double repeats_rms = unset;  ///< noise from repeats only [SI]; NaN without repeats
};

/// Returns the noise of a measured channel: the rms of declared or regression standard deviations
/// if every reading has one. Otherwise the noise is the scatter within repeats, if the repeats have
/// at least 3 degrees of freedom and are not all equal. The misfit of a model is never used,
/// because missing physics would then appear as noise.
[[nodiscard]] Noise estimate_noise(const record::Record& record, const record::Channel& measured);

/// Readings that were repeated during one stop, for example by several approaches of a probe.
struct Stop {
  double time = unset;  ///< time of the first reading [s]
  int readings = 0;
  double mean = unset;  ///< [SI]
  /// Standard deviation of one reading, from this stop only [SI]; NaN for a single reading.
  double std = unset;
};

/// Repeatability of a measured channel over all stops.
struct Repeatability {
  std::vector<Stop> stops{};
  double std = unset;  ///< standard deviation of one reading, pooled over all stops [SI]
  int degrees_of_freedom = 0;

  [[nodiscard]] bool known() const { return degrees_of_freedom > 0; }
};

/// Finds the scatter of readings within stops: groups of 2 to 30 readings of one run, with much
/// longer breaks between groups than within a group. A straight line is subtracted from groups of 4
/// or more readings, because the machine may move during the stop. The result is empty unless at
/// least two such groups contain at least half of the readings and have at least 3 degrees of
/// freedom.
[[nodiscard]] Repeatability repeatability(const record::Record& record,
                                          const record::Channel& measured);

/// Returns the scatter of single readings [SI], from stops if there are any, otherwise from
/// neighbouring readings. NaN if there are fewer than 32 readings, or if the readings are too far
/// apart in time (120 s) to separate noise from real motion.
[[nodiscard]] double noise_of_neighbours(const record::Record& record,
                                         const record::Channel& measured);

/// Returns an upper bound for the scatter of readings that are far apart in time, with one reading
/// in each stop [SI]. The bound uses the quarter of the readings closest to the line between their
/// neighbours. This quarter shows only noise if the machine was at rest for a quarter of the time.
/// NaN for fewer than 12 readings.
[[nodiscard]] double noise_of_calm_readings(const record::Record& record,
                                            const record::Channel& measured);

}  // namespace raceway::fit
