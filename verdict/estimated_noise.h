#pragma once

#include <optional>
#include <vector>

#include "fit/subject.h"

namespace raceway::verdict {

/// Noise that a diagnosis would assume for one channel.
struct EstimatedNoise {
  const record::Channel* channel = nullptr;
  double rms = unset;  ///< RMS noise of the readings that the estimate used [SI]
  /// Standard deviation of the reading in each row of the record [SI]. For rows that the estimate
  /// did not use, the standard deviation is calculated from the reading and the noise model. NaN
  /// for a row without a reading.
  std::vector<double> std;
};

/// Estimates the noise of each channel as a diagnosis does (fit::NoiseModel), for data without
/// declared noise and without repeats. The estimate does not use the residuals of the model. It
/// uses the residuals of a regression of the readings, with smooth functions of the inputs and all
/// candidate effects as regressors. The result is empty if a diagnosis of these data is impossible,
/// and for a spindle model or a correction, whose residuals stay correlated in time
/// (fit::Subject::approximates()).
[[nodiscard]] std::optional<std::vector<EstimatedNoise>> estimate_noise_as_diagnosis(
    const fit::Subject& subject, const record::Record& record);

}  // namespace raceway::verdict
