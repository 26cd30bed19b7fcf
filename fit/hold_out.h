#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Returns Judged::blockings() with the block of each observation instead of each row.
[[nodiscard]] std::vector<Blocking> blocks_of_observations(const Judged& subject,
                                                           const Record& record,
                                                           const Observations& observed);

/// Returns held-out errors [SI]: each block is predicted from a refit to the other blocks. The
/// refit is linearised at `fit`, which is exact for affine responses. The refit uses the weights
/// from `std` and keeps parameters at a bound fixed.
[[nodiscard]] Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                              const Eigen::VectorXd& measured,
                                              const Eigen::VectorXd& std, const Blocking& blocking);

/// Comparison of the held-out errors of two models.
struct HoldOut {
  std::string variable;
  std::vector<double> rmse_before{}, rmse_after{};  ///< held-out error of each channel [SI]
  /// Mean fall of the squared error, in units of the noise variance, and its 95 % interval from a
  /// bootstrap of the blocks.
  double improvement = unset, lower = unset, upper = unset;
  [[nodiscard]] bool better() const { return improvement > 0.0; }
  [[nodiscard]] bool worse() const { return upper < 0.0; }
};

[[nodiscard]] HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                       const Eigen::VectorXd& std, const Observations& observed,
                                       const Blocking& blocking);

/// Returns the rms error of each channel over several blockings [SI]; empty without blockings.
[[nodiscard]] std::vector<double> rms_over(const std::vector<HoldOut>& results,
                                           std::vector<double> HoldOut::*rmse);

/// Returns true if the second model is better in at least two blockings (or in all, if there are
/// fewer) and significantly worse in none.
[[nodiscard]] bool confirmed(const std::vector<HoldOut>& results);

}  // namespace raceway::fit
