#pragma once

#include <string_view>
#include <vector>

#include "record/record.h"

namespace raceway::fit {

/// Source of the standard deviations of readings.
enum class NoiseSource {
  none,
  declared,
  regression,  ///< by which the readings themselves were gained
  repeats,
  neighbours  ///< readings next to each other in time
};

/// The source in the words of the JSON results: "none", "declared", "regression", "repeats",
/// "neighbours".
[[nodiscard]] std::string_view name(NoiseSource source);

/// Noise of the readings of one channel.
struct Noise {
  double rms = unset;  ///< SI; NaN where nothing is known
  NoiseSource source = NoiseSource::none;
  int degrees_of_freedom = 0;  ///< of the repeats, also where the noise is declared
  double repeats_rms = unset;  ///< from repeats alone [SI], NaN without
};

/// Noise of a measured channel: declared or regression standard deviations if every reading has one
/// (their rms), otherwise the scatter within repeats where that has at least 3 degrees of freedom.
/// Never estimated from the misfit of a model, which would call missing physics noise.
[[nodiscard]] Noise estimate_noise(const record::Record& record, const record::Channel& measured);

/// Readings that were repeated in one stop, as a probe approaches several times.
struct Stop {
  double time = unset;  ///< of its first reading [s]
  int readings = 0;
  double mean = unset;  ///< [SI]
  double std = unset;   ///< of one reading, from this stop alone [SI]; NaN of one reading
};

/// Repeatability of a measured channel over all stops.
struct Repeatability {
  std::vector<Stop> stops{};
  double std = unset;  ///< of one reading, pooled [SI]
  int degrees_of_freedom = 0;

  [[nodiscard]] bool known() const { return degrees_of_freedom > 0; }
};

/// Scatter of readings within stops: groups of 2 to 30 readings of one run, with far longer breaks
/// between groups than within one. Of 4 readings or more what the machine moves meanwhile is taken
/// off as a straight line. Empty for a record without such groups.
[[nodiscard]] Repeatability repeatability(const record::Record& record,
                                          const record::Channel& measured);

/// Scatter of single readings [SI]: within stops, else from readings next to each other. NaN
/// where they stand too far apart to tell it from what is measured moving meanwhile.
[[nodiscard]] double noise_of_neighbours(const record::Record& record,
                                         const record::Channel& measured);

/// Upper bound of the scatter of single readings [SI] that stand far apart, one in each stop: from
/// the quarter of them that leaves the line between its neighbours least, which is noise where the
/// machine was at rest for a quarter of the time. NaN for fewer than 12 readings.
[[nodiscard]] double noise_of_calm_readings(const record::Record& record,
                                            const record::Channel& measured);

}  // namespace raceway::fit
