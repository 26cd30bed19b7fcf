#pragma once

#include <span>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "correction/share.h"

namespace raceway::correction {

/// Contribution of one part of a model to the displacement, at every row [m].
struct Contribution {
  std::string name{};  ///< name of a channel or effect, or "kinematic"
  std::vector<double> displacement{};
};

/// Simulates the displacement at every row of a record from rest [m], including the offset of the
/// model. After the input of a delay element leaves its domain, the result is NaN until the end of
/// that run. Beyond the range of the fit, lags remain linear, and continued() extrapolates laws.
/// Throws std::invalid_argument if the record lacks an input, or if the sampling interval of the
/// record differs from the interval of published coefficients.
void simulate(const Model& model, const Series& series, std::span<double> displacement);

/// Passes to `sink` each term that simulate() adds to the offset.
void show_parts(const Model& model, const Series& series, const Sink& sink);

/// Returns the contributions of the parts to the displacement, without the offset.
[[nodiscard]] std::vector<Contribution> contributions(const Model& model, const Series& series);

/// Returns the response of a channel, including the effects that act on this channel.
[[nodiscard]] Answer answer_of(const Model& model, const DrivenChannel& channel);

/// Returns the columns that a model needs besides the time.
[[nodiscard]] std::vector<const Channel*> inputs_of(const Model& model);

}  // namespace raceway::correction
