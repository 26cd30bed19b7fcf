#pragma once

#include <span>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "correction/share.h"

namespace raceway::correction {

/// Contribution of a channel, an effect or the kinematic law to the displacement at every row [m].
struct Contribution {
  std::string name{};  ///< name of a channel or effect, or "kinematic"
  std::vector<double> displacement{};
};

/// Simulates the displacement at every row of a record [m], including the offset of the model. All
/// lags start at zero in each run. If the input of a delay element is outside its domain in a row,
/// the result is NaN from this row until the end of the run. Beyond the range of the fit, lags
/// remain linear, and continued() extrapolates nonlinear formulas. Throws std::invalid_argument if
/// the record lacks an input, or if the model has published coefficients for a sampling interval
/// that differs from the time steps of the record.
void simulate(const Model& model, const Series& series, std::span<double> displacement);

/// Calls `sink` for each term of the displacement that simulate() computes, except the offset.
void show_parts(const Model& model, const Series& series, const Sink& sink);

/// Returns the contributions of all channels, effects and the kinematic law, without the offset.
[[nodiscard]] std::vector<Contribution> contributions(const Model& model, const Series& series);

/// Returns the changes that the effects of a model make to the lags of a channel.
[[nodiscard]] Answer answer_of(const Model& model, const DrivenChannel& channel);

/// Returns the record columns that a model needs in addition to the time.
[[nodiscard]] std::vector<const Channel*> inputs_of(const Model& model);

}  // namespace raceway::correction
