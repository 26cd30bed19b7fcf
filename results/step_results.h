#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"
#include "results/superposition.h"
#include "spindle/step_response.h"

/// Writes step responses as CSV and JSON. The names contain the units (docs/files.md). Unknown
/// values are empty in CSV and null in JSON.
namespace raceway::results {

/// Returns CSV with the columns speed_rpm, power_start_W, power_end_W, kinematic_um, K_um, T_min,
/// fit_rms_um, K1_um and T1_min of the faster lag, K2_um and T2_min of the slower lag,
/// fit_rms_two_um, end_um, front_force_N, highest_front_force_N and status. For load steps, the
/// text also has the columns axial_load_N and radial_load_N. For imported step responses, the text
/// has the column load_case. `model_text` is the text of the model file, or empty.
[[nodiscard]] std::string step_responses_text(const spindle::StepResponses& responses,
                                              std::string_view source, std::string_view model_text);

/// Returns the step responses with the laws K(P) and T(P) as JSON. `notes` contains remarks for the
/// user. `error` compares the correction with the simulation; null means not requested.
[[nodiscard]] std::string step_responses_json(const spindle::StepResponses& responses,
                                              const spindle::PowerLaws& laws,
                                              const std::vector<record::Note>& notes,
                                              const Superposition* error = nullptr);

}  // namespace raceway::results
