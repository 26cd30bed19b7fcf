#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Returns Judged::blockings(), in which Blocking::block has one entry for each observation instead
/// of each row.
[[nodiscard]] std::vector<Blocking> blocks_of_observations(const Judged& subject,
                                                           const Record& record,
                                                           const Observations& observed);

/// Returns the held-out error of each observation [SI], reading minus prediction. The prediction
/// comes from a refit to all blocks except the block of the observation. The refit is linearised at
/// `fit`, which is exact if the readings are linear in the parameters. The refit weights each
/// residual by 1/`std` and keeps parameters at a bound fixed. If the other blocks have no more
/// readings than the refit has parameters, the error is the residual of `fit`.
[[nodiscard]] Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                              const Eigen::VectorXd& measured,
                                              const Eigen::VectorXd& std, const Blocking& blocking);

/// Hold-out test: comparison of the held-out errors of a model before and after a change.
struct HoldOut {
  std::string variable;
  std::vector<double> rmse_before{}, rmse_after{};  ///< held-out RMS error of each channel [SI]
  /// Mean fall of the squared error divided by the noise variance [1], and its 95 % interval from a
  /// bootstrap of the blocks.
  double improvement = unset, lower = unset, upper = unset;
  [[nodiscard]] bool better() const { return improvement > 0.0; }
  [[nodiscard]] bool worse() const { return upper < 0.0; }
};

[[nodiscard]] HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                       const Eigen::VectorXd& std, const Observations& observed,
                                       const Blocking& blocking);

/// Returns the RMS of the errors over several hold-out tests, for each channel [SI]; empty without
/// tests. `rmse` is the member with the errors: HoldOut::rmse_before or HoldOut::rmse_after.
[[nodiscard]] std::vector<double> rms_over(const std::vector<HoldOut>& results,
                                           std::vector<double> HoldOut::*rmse);

/// Returns true if the changed model is better in at least two hold-out tests (or in all, if there
/// are fewer) and significantly worse in none.
[[nodiscard]] bool confirmed(const std::vector<HoldOut>& results);

}  // namespace raceway::fit
