#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/band.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

namespace raceway::session {

/// Returns warnings if balls of a bearing on the shaft lose contact with the inner ring, or if the
/// load of a bearing is below its minimum load against skidding. Each warning gives the speed range
/// in which the load is too low. The function finds the limits of this range by further
/// calculations between the given points, with an accuracy of half an rpm. `points` must be in
/// order of rising speed.
[[nodiscard]] std::vector<std::string> shaft_warnings(
    const model::Model& model, std::span<const shaft::ShaftPoint> points,
    std::span<const shaft::ShaftPrediction> predictions);

/// Returns the reason why the calculation of an operating point has not converged.
[[nodiscard]] std::string shaft_problem(const model::Model& model,
                                        const shaft::ShaftPrediction& prediction);

/// Returns the half widths of the 95 % bands of shaft position, torque and power loss at every
/// operating point.
[[nodiscard]] results::BandOfResult shaft_band(const model::Band& band,
                                               std::span<const shaft::ShaftPoint> points);

}  // namespace raceway::session
