#pragma once

#include <Eigen/Core>

#include "fit/observations.h"

namespace raceway::fit {

/// The columns of a surface at the observations, of the size `size` of the readings: `size` times
/// products of powers of the inputs, each centred and scaled to [-1, 1]. What contains an input
/// that does not vary is left out.
[[nodiscard]] Eigen::MatrixXd surface_columns(const Surface& surface, const Observations& observed,
                                              const Eigen::VectorXd& size);

/// `size` times an indicator of each level, for channels measured at few levels: what a smooth
/// surface is too smooth for.
[[nodiscard]] Eigen::MatrixXd level_columns(const std::vector<const Channel*>& channels,
                                            const Record& record, const Observations& observed,
                                            const Eigen::VectorXd& size);

}  // namespace raceway::fit
