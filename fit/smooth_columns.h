#pragma once

#include <Eigen/Core>

#include "fit/observations.h"

namespace raceway::fit {

/// Returns the terms of a regression on a smooth surface: one row for each observation, one column
/// for each term. Each term is a product of powers of the inputs, multiplied by `size`, the typical
/// size of each reading. Each input is shifted and scaled to [-1, 1]. The matrix has no terms of
/// inputs that do not vary.
[[nodiscard]] Eigen::MatrixXd surface_columns(const Surface& surface, const Observations& observed,
                                              const Eigen::VectorXd& size);

/// Returns regression columns for steps, which a smooth surface cannot describe. A level is a group
/// of nearly equal values of a channel. Each channel with 3 to 12 levels has one column for each
/// level. The entries of the column are `size`, the typical size of each reading, at the
/// observations of this level, and 0 at all other observations.
[[nodiscard]] Eigen::MatrixXd level_columns(const std::vector<const Channel*>& channels,
                                            const Record& record, const Observations& observed,
                                            const Eigen::VectorXd& size);

}  // namespace raceway::fit
