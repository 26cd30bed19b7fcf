#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "fit/data_set.h"
#include "fit/free_parameters.h"
#include "fit/model.h"

namespace raceway::fit {

enum class FitStatus {
  not_run,
  converged,
  iteration_limit,
  failed,         ///< the optimiser gave up; the values are where it stopped
  nothing_to_fit  ///< the data depend on none of the free parameters
};

/// The status in the words of the JSON results, e.g. "iteration_limit".
[[nodiscard]] std::string_view name(FitStatus status);

enum class Bound { none, lower, upper };

/// One fitted parameter, in the unit in which files give it.
struct FittedParameter {
  std::string name;
  std::string unit;
  double start = unset;
  double value = unset;
  double std =
      unset;  ///< standard error; NaN at a bound, where not identifiable, without redundancy
  double lower = unset, upper = unset;
  Bound at_bound = Bound::none;
  bool identifiable = true;  ///< false: the data do not fix it, alone or against another parameter
  bool held = false;         ///< left at its start, because another parameter does the same
};

struct Calibration {
  Model model;  ///< with the fitted values
  std::vector<FittedParameter> parameters{};
  Eigen::MatrixXd correlation{};  ///< of the estimates, NaN where there is no standard error
  int rows = 0;                   ///< used
  std::vector<int> rows_not_predicted{};  ///< lines of rows without balance, not used
  int degrees_of_freedom = 0;             ///< rows minus parameters that moved
  bool weighted = false;                  ///< by the standard deviation of the rows
  double reduced_chi_square = unset;  ///< χ²/degrees of freedom; NaN where no std is known [1]
  double excess_scatter = 0.0;  ///< added to the std of each row, see calibrate() [N m] or [m]
  double rmse_before = unset, rmse_after = unset;  ///< of torque [N m] or displacement [m]
  Quantity quantity = Quantity::friction_torque;
  int iterations = 0;
  FitStatus status = FitStatus::not_run;
  std::vector<std::string> messages{};  ///< what the user should know, one line each

  [[nodiscard]] bool converged() const { return status == FitStatus::converged; }
};

/// Re-fits the free parameters of a model to measured friction torque of a rig, or to measured
/// displacement of a shaft, within their bounds.
///
///   minimise Σ (M_predicted - M_measured)² / (std² + excess²)
///
/// with the standard deviations of the rows if every row has one, otherwise with equal weights and
/// the noise estimated from what is left. `excess` is zero unless χ² exceeds its degrees of
/// freedom; then it is the common scatter that brings χ² down to them [PauleMandel1982], found with
/// the parameters. Without it a model that misses something would be bent to the few quietest rows,
/// and be far too sure of its parameters. Ball equilibrium is solved once per row, and again only
/// where a parameter moves the condition of the bearing. Rows without balance are left out and
/// listed.
///
/// Standard errors are those of the linearised problem, sqrt(diag (JᵀWJ)^-1). They do not cover
/// what a missing effect does to the values.
///
/// A parameter that the data cannot tell from those before it in the list (z and y at one load) is
/// held at its start; all of the group are marked not identifiable. So is one whose standard error
/// exceeds the range of its bounds.
/// Throws std::invalid_argument: torque of a shaft or displacement without one, unknown parameter,
/// fewer rows than parameters.
[[nodiscard]] Calibration calibrate(const Model& model, const DataSet& data);

}  // namespace raceway::fit
