#pragma once

#include <vector>

#include "session/detail/varied_model.h"

namespace raceway::session::varied {

/// Fills in the indices of Sobol' of all predictions of `s`; `places` are the indices in `data` of
/// s.data. Part of session/sensitivity.cpp. Throws text::InputError for what
/// cannot be sampled.
void sample(const Data& data, const Predictor& predictor, const SensitivityQuestion& q,
            const std::vector<std::size_t>& places, results::Sensitivity& s);

}  // namespace raceway::session::varied
