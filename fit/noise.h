#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "fit/data_set.h"

namespace raceway::fit {

/// The source in the words of the JSON results: "none", "declared", "regression", "repeats".
[[nodiscard]] std::string_view name(NoiseSource source);

/// Rows that measure the same: indices into DataSet::rows.
using RepeatGroup = std::vector<std::size_t>;

/// When two rows stand at the same operating point.
struct SamePoint {
  double relative = 1e-3;    ///< difference of speed, loads and preload [1]
  double temperature = 0.1;  ///< of lubricant and rings [K]; 0.3 % of a viscous torque
};

/// Groups of two or more rows at the same operating point. Speed differs from row to row in a
/// coast-down, so it has none.
[[nodiscard]] std::vector<RepeatGroup> find_repeats(const DataSet& data,
                                                    const SamePoint& same = {});

/// How much of the measured values is scatter.
struct Noise {
  double rms = unset;  ///< in the unit of the quantity [N m] or [m]; NaN where nothing is known
  NoiseSource source = NoiseSource::none;
  int degrees_of_freedom = 0;  ///< of the repeats, also where the noise is declared
  double repeats_rms = unset;  ///< from repeats alone, NaN without
};

/// Noise of a data set: declared or regression standard deviations if every row has one (their
/// rms), otherwise the scatter within repeats where that has at least 3 degrees of freedom. Never
/// estimated from the misfit of a model, which would call missing physics noise.
[[nodiscard]] Noise estimate_noise(const DataSet& data);

}  // namespace raceway::fit
