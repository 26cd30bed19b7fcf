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
  std::string name{};  ///< of the channel or the effect; "kinematic"
  std::vector<double> displacement{};
};

/// Displacement at every row of a record from rest [m], the offset of the model included. NaN from
/// where a power leaves the range of a delay element to the end of that run. Beyond the range of
/// the model lags go on in proportion, and laws as continued() says. Throws std::invalid_argument
/// where the record lacks an input, or its sampling differs from the interval of printed
/// coefficients.
void simulate(const Model& model, const Series& series, std::span<double> displacement);

/// Gives all that simulate() adds to the offset to a sink.
void show_parts(const Model& model, const Series& series, const Sink& sink);

/// Contributions of the parts to the displacement, without the offset.
[[nodiscard]] std::vector<Contribution> contributions(const Model& model, const Series& series);

/// Response of a channel of a model, with the effects that act on it.
[[nodiscard]] Answer answer_of(const Model& model, const DrivenChannel& channel);

/// Columns that a model needs in addition to the time.
[[nodiscard]] std::vector<const Channel*> inputs_of(const Model& model);

}  // namespace raceway::correction
