#pragma once

#include <Eigen/Core>

#include "fit/observations.h"

namespace raceway::fit {

/// Returns the terms of a surface at the observations (observations x terms): `size`, the typical
/// size of each reading, times a product of powers of the inputs. Each input is shifted and scaled
/// to [-1, 1]. Terms with an input that does not vary are left out.
[[nodiscard]] Eigen::MatrixXd surface_columns(const Surface& surface, const Observations& observed,
                                              const Eigen::VectorXd& size);

/// Returns one column for each level of each channel with 3 to 12 levels: `size` at the
/// observations of this level, and 0 at all others. The columns describe steps, which a smooth
/// surface cannot describe.
[[nodiscard]] Eigen::MatrixXd level_columns(const std::vector<const Channel*>& channels,
                                            const Record& record, const Observations& observed,
                                            const Eigen::VectorXd& size);

}  // namespace raceway::fit
