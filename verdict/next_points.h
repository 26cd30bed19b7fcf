#pragma once

#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

struct NextPoints {
  std::vector<SuggestedMeasurement> points;
  std::vector<fit::Axis> axes;  ///< inputs that a point sets, with their possible values
  /// Predicted χ² that remains if the wrong one of two explanations is refitted to the present and
  /// the new readings [1]. The two explanations are the pair that is hardest to separate. For
  /// `predicted_separation`, the new readings are at `points`; for `separation_by_repetition`, the
  /// same number of readings repeats existing rows.
  double predicted_separation = unset, separation_by_repetition = unset;
};

/// Returns the measuring points that best separate rival explanations, from the values in
/// Subject::axes(). The design is T-optimal for the pair of explanations that is hardest to
/// separate. The search adds points one by one until the predicted separation reaches 20 or `most`
/// readings, including repeats, are planned. It then replaces points by better ones, one at a time.
/// The result is empty for fewer than two explanations, for a model without axes, or for a model
/// whose readings depend on earlier rows.
[[nodiscard]] NextPoints next_points(const Evidence& evidence,
                                     const std::vector<const Explanation*>& rivals, int most = 12);

}  // namespace raceway::verdict
