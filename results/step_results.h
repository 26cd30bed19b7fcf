#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"
#include "results/superposition.h"
#include "spindle/step_response.h"

/// Writes step responses as CSV and JSON, with units in the keys (docs/files.md). Unknown values
/// are empty or null.
namespace raceway::results {

/// Returns the columns speed_rpm, power_start_W, power_end_W, kinematic_um, K_um, T_min,
/// fit_rms_um, the two lags K1_um, T1_min (the faster) and K2_um, T2_min, fit_rms_two_um, end_um,
/// front_force_N, highest_front_force_N and status, plus columns for the load of load steps, and
/// load_case for imported responses. `model_text` may be empty.
[[nodiscard]] std::string step_responses_text(const spindle::StepResponses& responses,
                                              std::string_view source, std::string_view model_text);

/// Returns the step responses with the laws K(P) and T(P) as JSON. `notes` are texts for the user.
/// `error` is the error of the correction; null if it was not requested.
[[nodiscard]] std::string step_responses_json(const spindle::StepResponses& responses,
                                              const spindle::PowerLaws& laws,
                                              const std::vector<record::Note>& notes,
                                              const Superposition* error = nullptr);

}  // namespace raceway::results
