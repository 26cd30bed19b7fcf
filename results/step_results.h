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

/// Returns CSV with one row for each step. The fit with one lag gives the columns K_um (gain),
/// T_min (time constant) and fit_rms_um. The fit with two lags gives K1_um and T1_min of the faster
/// lag, K2_um and T2_min of the slower lag, and fit_rms_two_um. The other columns are speed_rpm,
/// power_start_W, power_end_W, kinematic_um (immediate displacement), end_um (displacement at the
/// end of the step minus kinematic_um), front_force_N, highest_front_force_N and status. Load steps
/// have the additional columns axial_load_N and radial_load_N. Imported step responses have the
/// additional column load_case. `model_text` is the text of the model file; it may be empty.
[[nodiscard]] std::string step_responses_text(const spindle::StepResponses& responses,
                                              std::string_view source, std::string_view model_text);

/// Returns the step responses with the laws K(P) and T(P) as JSON. K is the gain, T the time
/// constant, and P the power. `notes` contains remarks for the user. `error` is the comparison of
/// the correction with the simulation; null if no comparison was requested.
[[nodiscard]] std::string step_responses_json(const spindle::StepResponses& responses,
                                              const spindle::PowerLaws& laws,
                                              const std::vector<record::Note>& notes,
                                              const Superposition* error = nullptr);

}  // namespace raceway::results
