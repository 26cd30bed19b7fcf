#pragma once

#include <array>
#include <vector>

#include "session/detail/varied_model.h"

/// Derivatives of every prediction with respect to every datum (see sensitivity()); parts of
/// session/sensitivity.cpp.
namespace raceway::session::varied {

/// Predictions with one datum moved to both sides.
struct Around {
  double step = unset;  // 0: not varied
  // At value + step, - step, + step/2, - step/2, + spread, - spread.
  std::array<Outcome, 6> at;
};

/// Sets the spreads that the question gives or the model carries as standard errors.
void take_spreads(const model::Model& model, const SensitivityQuestion& q, Data& data);

/// Predicts with each datum moved. Sets the usual spread of data without one, and lists data that
/// cannot be varied.
[[nodiscard]] std::vector<Around> predict_around(Data& data, const Predictor& predictor,
                                                 const SensitivityQuestion& q,
                                                 results::Sensitivity& s);

/// Lists which data enter, which do not, and which the samples can vary. Returns the index in
/// `data` of each of s.data.
[[nodiscard]] std::vector<std::size_t> take_what_enters(const Data& data,
                                                        const std::vector<Around>& around,
                                                        const std::vector<double>& here,
                                                        bool sampled, results::Sensitivity& s);

/// Fills in the derivatives of the prediction with index i among all, of the data s.data, which
/// have `places` in `around`.
void differentiate(std::size_t i, const std::vector<results::VariedDatum>& data,
                   const std::vector<std::size_t>& places, const std::vector<Around>& around,
                   results::PredictionSensitivity& p);

}  // namespace raceway::session::varied
