#pragma once

#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

struct NextPoints {
  std::vector<SuggestedMeasurement> points;
  std::vector<fit::Axis> axes;  ///< of the points
  /// Squared misfit over variance that the wrong one of the worst pair would keep after refit, with
  /// these points and with as many repeats of rows that exist.
  double predicted_separation = unset, separation_by_repetition = unset;
};

/// Points on the subject's axes that best separate rival explanations: T-optimal, the worst pair
/// counts, by greedy choice and exchange until the predicted separation reaches 20 or `most` points
/// (with their repeats) are used. None where the subject has no axes.
[[nodiscard]] NextPoints next_points(const Evidence& evidence,
                                     const std::vector<const Explanation*>& rivals, int most = 12);

}  // namespace raceway::verdict
