#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"
#include "results/superposition.h"
#include "spindle/step_response.h"

/// Step responses as CSV and as JSON, keys with their units (docs/files.md). What is not known is
/// empty or null.
namespace raceway::results {

/// speed_rpm, power_start_W, power_end_W, kinematic_um, K_um, T_min, fit_rms_um, the two lags
/// K1_um, T1_min (the faster), K2_um, T2_min, fit_rms_two_um, highest_front_force_N, status;
/// load_case where they were read. `model_text` may be empty.
[[nodiscard]] std::string step_responses_text(const spindle::StepResponses& responses,
                                              std::string_view source, std::string_view model_text);

/// The step responses with the laws K(P) and T(P) as JSON. `notes`: for the user. `error` of the
/// correction, null if not requested.
[[nodiscard]] std::string step_responses_json(const spindle::StepResponses& responses,
                                              const spindle::PowerLaws& laws,
                                              const std::vector<record::Note>& notes,
                                              const Superposition* error = nullptr);

}  // namespace raceway::results
