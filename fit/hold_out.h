#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Blocks by observation instead of by row.
[[nodiscard]] std::vector<Blocking> blocks_of_observations(const Judged& subject,
                                                           const Record& record,
                                                           const Observations& observed);

/// Errors of readings that a fit did not see [SI]: each block predicted from a refit to the
/// others. The refit is linearised at `fit` (exact for affine responses), weighted by `std`, and
/// keeps to the bounds by holding parameters that are at one.
[[nodiscard]] Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                              const Eigen::VectorXd& measured,
                                              const Eigen::VectorXd& std, const Blocking& blocking);

/// Error of one model against another on readings that neither saw.
struct HoldOut {
  std::string variable;
  std::vector<double> rmse_before{}, rmse_after{};  ///< of each channel [SI]
  /// Mean fall of the squared error, in units of the noise variance, and its 95 % interval by
  /// bootstrap of the blocks.
  double improvement = unset, lower = unset, upper = unset;
  [[nodiscard]] bool better() const { return improvement > 0.0; }
  [[nodiscard]] bool worse() const { return upper < 0.0; }
};

[[nodiscard]] HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                       const Eigen::VectorXd& std, const Observations& observed,
                                       const Blocking& blocking);

/// Root mean square over several blockings, of each channel [SI]; empty where there is none.
[[nodiscard]] std::vector<double> rms_over(const std::vector<HoldOut>& results,
                                           std::vector<double> HoldOut::*rmse);

/// Better in two blockings (in all, where there are fewer), significantly worse in none.
[[nodiscard]] bool confirmed(const std::vector<HoldOut>& results);

}  // namespace raceway::fit
