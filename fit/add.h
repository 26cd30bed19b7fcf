#pragma once

#include <span>
#include <string>
#include <vector>

#include "effects/effect.h"
#include "fit/calibrate.h"
#include "fit/compare.h"
#include "fit/hold_out.h"
#include "fit/noise_model.h"

namespace raceway::fit {

/// A model with effects switched on, and what that bought.
struct AddResult {
  Calibration calibration;  ///< `calibration.model` is the new model, all free parameters fitted
  Comparison before{}, after{};     ///< in sample, each refitted
  NoiseModel noise{};               ///< by which rows were weighed, in the order of `before`
  std::vector<HoldOut> hold_out{};  ///< blocks of rows that neither fit saw
  double rmse_held_out_before = unset,
         rmse_held_out_after = unset;  ///< rms over the blockings [N m] or [m]
  bool refused = false;  ///< no better on rows it did not see, or the fit did not converge
  std::string reason{};  ///< why, in a sentence; empty where accepted
  std::vector<std::string> messages{};
};

/// Switches effects on by id, refits all free parameters with them and judges the result.
///
/// Refused: what is not better on blocks of rows that the fit did not see (two of the blockings by
/// speed, load and temperature, significantly worse in none); a fall of -2 ln L that chance could
/// bring; a single effect that leaves structure where another one explains the data to the noise.
///
/// An id is one of the catalogue, or of an effect of the user's own that stands in the model with a
/// size of zero. Rows without a declared standard deviation are weighted by the estimated noise.
/// Throws std::invalid_argument: no effect, an unknown one (with the nearest ids), one the model
/// has already, one that the data cannot feed (with what they lack) or cannot tell from the base
/// parameters.
[[nodiscard]] AddResult add(const Model& model, std::span<const std::string> ids,
                            const DataSet& data);

}  // namespace raceway::fit
