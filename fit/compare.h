#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/data_set.h"
#include "fit/model.h"
#include "fit/noise.h"

namespace raceway::fit {

/// What a misfit can be sorted by.
enum class Variable { speed, axial_load, radial_load, temperature, run, preload };

/// "speed", "axial_load", "radial_load", "temperature", "run", "preload".
[[nodiscard]] std::string_view name(Variable variable);

/// The value of a row by which it is sorted, SI; the index of its run for `run`.
[[nodiscard]] double value_of(Variable variable, const Row& row);

/// Error within one range of one variable; a level of it where the data have few.
struct ErrorRange {
  Variable variable = Variable::speed;
  double from = unset, to = unset;  ///< smallest and largest value within, SI; index for `run`
  std::string run;                  ///< run_id, empty unless variable is `run`
  int rows = 0;
  double rmse = unset;  ///< [N m] or [m]
  double bias = unset;  ///< mean of prediction minus reading [N m] or [m]
};

/// One row, prediction against reading, [N m] or [m].
struct RowError {
  std::size_t row = 0;  ///< index into DataSet::rows
  int line = 0;
  double predicted = unset;
  double measured = unset;
  double residual = unset;  ///< prediction minus reading
  double sigmas = unset;    ///< residual over standard deviation, NaN where that is not known [1]
};

/// Whether the misfit is larger than the noise.
///   declared or regression   statistic = χ²/degrees of freedom, χ² distribution
///   repeats                  statistic = F, lack of fit over pure error, F distribution
///   none                     NaN
struct LackOfFit {
  double statistic = unset;
  double p_value = unset;
  int degrees_of_freedom = 0;        ///< rows (or groups of repeats) minus fitted parameters
  int noise_degrees_of_freedom = 0;  ///< of the pure error, 0 where the noise is declared
};

/// Whether neighbours in speed err alike; needs no noise. Rows are strung by run, loads and
/// temperature, then by speed; correlation = mean product of neighbours over mean square, for pure
/// noise about normal with a variance of 1/pairs. p is one-sided. It also rises where the noise
/// itself drifts along the run.
struct Pattern {
  double correlation = unset;  ///< in [-1, 1], NaN below 8 pairs
  double p_value = unset;
  int pairs = 0;
};

enum class Judgement {
  structure,  ///< p < 0.01 in the lack-of-fit test, or in the pattern where the noise is unknown
  noise,      ///< the misfit is no larger than the noise
  unknown     ///< the noise is not known, and no pattern shows
};

/// A model held against measurements. Residuals are prediction minus reading.
struct Comparison {
  Quantity quantity = Quantity::friction_torque;
  int rows = 0;                                                     ///< compared
  double rmse = unset, mae = unset, max_abs = unset, bias = unset;  ///< [N m] or [m]
  /// 100 (1 - |y - ŷ| / |y - mean y|) in Euclidean norms: 100 is perfect, 0 no better than the
  /// mean, negative is worse. NaN if all readings are equal.
  double fit_percent = unset;
  Noise noise;
  LackOfFit lack_of_fit;
  Pattern pattern;
  Judgement judgement = Judgement::unknown;
  std::vector<ErrorRange> where;        ///< worst first; only of variables that vary
  std::vector<RowError> worst;          ///< the five worst rows, worst first
  std::vector<RowError> errors;         ///< all compared rows, in the order of the data
  std::vector<int> rows_not_predicted;  ///< lines of rows without balance
  std::string statement;  ///< in one sentence: how wrong, structure or noise, and where
};

/// Compares predicted and measured friction torque of the rig, or axial displacement of the shaft.
/// `fitted_parameters` of the model were fitted to these very data; they cost degrees of freedom in
/// the test (0 where in doubt, which makes the test milder). Throws std::invalid_argument if
/// nothing can be compared: torque of a shaft, displacement without a shaft, no row, none
/// predicted.
[[nodiscard]] Comparison compare(const Model& model, const DataSet& data,
                                 int fitted_parameters = 0);

/// The same for predictions made elsewhere: `predicted` by row of `data`, NaN where there is none.
[[nodiscard]] Comparison compare(const std::vector<double>& predicted, const DataSet& data,
                                 int fitted_parameters = 0);

}  // namespace raceway::fit
