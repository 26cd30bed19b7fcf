#pragma once

#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

struct NextPoints {
  std::vector<SuggestedMeasurement> points;
  std::vector<fit::Axis> axes;  ///< inputs that a measuring point sets, with their possible values
  /// Predicted χ² [1], without the contribution of the noise, if one of the rival explanations is
  /// true and another one is fitted to the present and the new readings. The value is the minimum
  /// over all pairs of rival explanations. For `predicted_separation`, the new readings are at
  /// `points`. For `separation_by_repetition`, the same number of new readings repeats existing
  /// rows.
  double predicted_separation = unset, separation_by_repetition = unset;
};

/// Chooses the measuring points that best separate rival explanations of the same readings. An
/// explanation is a fit of the model with added effects. Possible points have the input values in
/// Subject::axes(). The design is T-optimal for the pair of explanations that is hardest to
/// separate. The search adds points one by one until the predicted separation reaches 20 or `most`
/// readings, including repeats, are planned. The search then replaces points by better points, one
/// at a time. The result is empty if there are fewer than two explanations, if Subject::axes() is
/// empty, or if readings depend on earlier rows.
[[nodiscard]] NextPoints next_points(const Evidence& evidence,
                                     const std::vector<const Explanation*>& rivals, int most = 12);

}  // namespace raceway::verdict
