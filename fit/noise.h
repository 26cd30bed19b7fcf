#pragma once

#include <string_view>

#include "record/record.h"

namespace raceway::fit {

/// Source of the standard deviations of readings.
enum class NoiseSource {
  none,
  declared,
  regression,  ///< by which the readings themselves were gained
  repeats,
  neighbours  ///< readings beside each other in time
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

/// Scatter of single readings [SI], from those beside them: NaN where they stand too far apart to
/// tell it from what is measured moving meanwhile.
[[nodiscard]] double noise_of_neighbours(const record::Record& record,
                                         const record::Channel& measured);

}  // namespace raceway::fit
