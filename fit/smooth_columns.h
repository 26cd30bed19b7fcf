#pragma once

#include <Eigen/Core>

#include "fit/observations.h"

namespace raceway::fit {

/// Returns the columns of a surface at the observations: `size`, the size of the readings, times
/// products of powers of the inputs. Each input is centred and scaled to [-1, 1]. Terms with an
/// input that does not vary are left out.
[[nodiscard]] Eigen::MatrixXd surface_columns(const Surface& surface, const Observations& observed,
                                              const Eigen::VectorXd& size);

/// Returns `size` times an indicator of each level, for channels with 3 to 12 levels. These columns
/// describe steps, which a smooth surface cannot describe.
[[nodiscard]] Eigen::MatrixXd level_columns(const std::vector<const Channel*>& channels,
                                            const Record& record, const Observations& observed,
                                            const Eigen::VectorXd& size);

}  // namespace raceway::fit
