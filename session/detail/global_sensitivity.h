#pragma once

#include <vector>

#include "session/detail/varied_model.h"

namespace raceway::session::varied {

/// Computes the Sobol' indices of all predictions of `s`, for sensitivity(). `places` are the
/// indices in `data` of the entries of s.data. Throws text::InputError if no datum with a spread
/// influences a prediction, and for an invalid number of samples.
void sample(const Data& data, const Predictor& predictor, const SensitivityQuestion& q,
            const std::vector<std::size_t>& places, results::Sensitivity& s);

}  // namespace raceway::session::varied
