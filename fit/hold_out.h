#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Returns the result of Judged::blockings(), the divisions into blocks for hold-out tests, but
/// with one entry of Blocking::block for each observation instead of each row.
[[nodiscard]] std::vector<Blocking> blocks_of_observations(const Judged& subject,
                                                           const Record& record,
                                                           const Observations& observed);

/// Returns the held-out error of each observation [SI], reading minus prediction. The prediction
/// comes from a refit to all blocks except the block of the observation. The refit uses the
/// predictions linearised at `fit`, so it is exact if the predictions are linear in the parameters.
/// The refit weights each residual by 1/`std` and does not change parameters that are at a bound in
/// `fit`. If the other blocks have too few readings to determine the refitted parameters, the error
/// is the residual of `fit`.
[[nodiscard]] Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                              const Eigen::VectorXd& measured,
                                              const Eigen::VectorXd& std, const Blocking& blocking);

/// Hold-out test: comparison of the held-out errors of a model before and after a change.
struct HoldOut {
  std::string variable;  ///< quantity that divides the rows into blocks (Blocking::variable)
  std::vector<double> rmse_before{}, rmse_after{};  ///< held-out RMS error of each channel [SI]
  /// Mean decrease of the squared error due to the change of the model, divided by the noise
  /// variance [1]. `lower` and `upper` are the limits of its 95 % confidence interval, from a
  /// bootstrap of the blocks.
  double improvement = unset, lower = unset, upper = unset;
  [[nodiscard]] bool better() const { return improvement > 0.0; }
  [[nodiscard]] bool worse() const { return upper < 0.0; }
};

/// Compares the held-out errors of a model `before` and `after` a change [SI]. `std` contains the
/// standard deviations of the readings [SI].
[[nodiscard]] HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                       const Eigen::VectorXd& std, const Observations& observed,
                                       const Blocking& blocking);

/// Returns the RMS of the errors over several hold-out tests, for each channel [SI]; empty without
/// tests. `rmse` is the member with the errors: HoldOut::rmse_before or HoldOut::rmse_after.
[[nodiscard]] std::vector<double> rms_over(const std::vector<HoldOut>& results,
                                           std::vector<double> HoldOut::*rmse);

/// Returns true if the changed model is better in at least two hold-out tests and significantly
/// worse in none. If there is only one test, the changed model must be better in this test; without
/// tests, the result is true.
[[nodiscard]] bool confirmed(const std::vector<HoldOut>& results);

}  // namespace raceway::fit
