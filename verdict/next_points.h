#pragma once

#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

struct NextPoints {
  std::vector<SuggestedMeasurement> points;
  std::vector<fit::Axis> axes;  ///< axes of the points
  /// Predicted separation of the two explanations that are hardest to separate: the squared misfit
  /// over variance that remains if the wrong explanation is refitted. The first value is for these
  /// points, the second for an equal number of repeats of existing rows.
  double predicted_separation = unset, separation_by_repetition = unset;
};

/// Returns the points on the axes of the model that best separate rival explanations. The design is
/// T-optimal for the worst pair. The search chooses and exchanges points one by one. The search
/// stops if the predicted separation reaches 20 or if `most` points, including repeats, are used.
/// The result is empty for fewer than two explanations, for a model without axes, and for a model
/// whose readings depend on earlier rows.
[[nodiscard]] NextPoints next_points(const Evidence& evidence,
                                     const std::vector<const Explanation*>& rivals, int most = 12);

}  // namespace raceway::verdict
