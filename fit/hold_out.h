#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/data_set.h"
#include "fit/response.h"

namespace raceway::fit {

/// Rows held out together, block by block.
struct Blocking {
  std::string variable;      ///< "speed", "axial_load", "temperature" or "run"
  std::vector<int> block{};  ///< of each row
  int blocks = 0;
};

/// One level (or range of levels, where there are many) of each variable that varies at a time;
/// runs where there are three or more.
[[nodiscard]] std::vector<Blocking> blockings(const DataSet& data);

/// Errors of rows that a fit did not see [N m] or [m]: each block predicted from a refit to the
/// others. The refit is linearised at `fit` (exact for affine responses), weighted by `std`, and
/// keeps to the bounds by holding parameters that are at one.
[[nodiscard]] Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                              const Eigen::VectorXd& measured,
                                              const Eigen::VectorXd& std, const Blocking& blocking);

/// Error of one model against another on rows that neither saw.
struct HoldOut {
  std::string variable;
  double rmse_before = unset, rmse_after = unset;  ///< [N m] or [m]
  /// Mean fall of the squared error, in units of the noise variance, and its 95 % interval by
  /// bootstrap of the blocks.
  double improvement = unset, lower = unset, upper = unset;
  [[nodiscard]] bool better() const { return improvement > 0.0; }
  [[nodiscard]] bool worse() const { return upper < 0.0; }
};

[[nodiscard]] HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                       const Eigen::VectorXd& std, const Blocking& blocking);

/// Better in two blockings (in all, where there are fewer), significantly worse in none.
[[nodiscard]] bool confirmed(const std::vector<HoldOut>& results);

}  // namespace raceway::fit
