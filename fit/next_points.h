#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fit/attribution.h"

namespace raceway::fit {

/// A measurement that would tell apart what the data cannot.
struct SuggestedMeasurement {
  bearing::OperatingPoint point;
  double preload = unset;  ///< of the sets of a shaft [N]; NaN: as it is
  int repeats = 2;
  std::string separates{};             ///< ids, e.g. "seal-friction / load-offset"
  double difference_in_sigma = unset;  ///< of that pair at this point, before any refit [1]
};

struct NextPoints {
  std::vector<SuggestedMeasurement> points;
  /// Squared misfit over variance that the wrong one of the worst pair would keep after refit, with
  /// these points and with as many repeats of rows that exist.
  double predicted_separation = unset, separation_by_repetition = unset;
};

/// Points within the ranges of the data, on a shaft also half and twice the only preload that was
/// measured, that best separate rival explanations: T-optimal, the
/// worst pair counts, by greedy choice and exchange until the predicted separation reaches 20 or
/// `most` points (with their repeats) are used.
[[nodiscard]] NextPoints next_points(const Problem& problem, const NoiseModel& noise,
                                     const std::vector<const Explanation*>& rivals, int most = 12);

/// What the file of a shaft should hold beside, so that what heat does is told from the rest: heat
/// may also be what these data cannot show. Nothing for a bearing on a rig.
[[nodiscard]] std::vector<std::string> records_needed(
    const Problem& problem, const std::vector<const Explanation*>& rivals);

}  // namespace raceway::fit
