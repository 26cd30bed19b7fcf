#pragma once

#include <optional>
#include <vector>

#include "fit/data_set.h"
#include "fit/model.h"

namespace raceway::fit {

/// What a diagnosis would take for the noise of a data set.
struct EstimatedNoise {
  double rms = unset;       ///< over the rows used [N m]
  std::vector<double> std;  ///< by row of the data [N m]; by the reading where a row was not used
};

/// The noise of NoiseModel, for data that declare none and repeat no rows. It comes from what a
/// regression on smooth surfaces and all effects of the catalogue leaves, not from the misfit of
/// `model`. Nothing where the data could not carry a diagnosis.
[[nodiscard]] std::optional<EstimatedNoise> estimate_noise_as_diagnosis(const Model& model,
                                                                        const DataSet& data);

}  // namespace raceway::fit
