#pragma once

#include <array>
#include <vector>

#include "session/detail/varied_model.h"

/// Computes the derivative of every prediction with respect to every datum (see sensitivity()).
/// Only sensitivity() uses this header.
namespace raceway::session::varied {

/// Predictions after one datum was changed in both directions.
struct Around {
  double step = unset;  // step of the datum; 0: the datum is not varied
  // Predictions at value + step, - step, + step/2, - step/2, + spread, - spread.
  std::array<Outcome, 6> at;
};

/// Sets the spreads from the question or from the standard errors in the model.
void take_spreads(const model::Model& model, const SensitivityQuestion& q, Data& data);

/// Computes the predictions with each datum changed, one at a time. Sets the usual spread for data
/// without a given spread, and lists data that cannot be varied.
[[nodiscard]] std::vector<Around> predict_around(Data& data, const Predictor& predictor,
                                                 const SensitivityQuestion& q,
                                                 results::Sensitivity& s);

/// Lists the data that affect a prediction, the data without an effect, and the data that can be
/// sampled for the Sobol' indices. Returns the index in `data` of each entry of s.data.
[[nodiscard]] std::vector<std::size_t> take_what_enters(const Data& data,
                                                        const std::vector<Around>& around,
                                                        const std::vector<double>& here,
                                                        bool sampled, results::Sensitivity& s);

/// Computes the derivatives of prediction `i` with respect to the data s.data, whose indices in
/// `around` are `places`.
void differentiate(std::size_t i, const std::vector<results::VariedDatum>& data,
                   const std::vector<std::size_t>& places, const std::vector<Around>& around,
                   results::PredictionSensitivity& p);

}  // namespace raceway::session::varied
