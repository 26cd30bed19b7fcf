#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/judgement.h"
#include "model/model.h"
#include "spindle/spindle.h"

/// Results of a spindle simulation as CSV and JSON; keys and columns carry their units.
namespace raceway::results {

/// Difference between the results of the chosen cells and of other ones.
struct MeshEstimate {
  std::size_t cells = 0, other_cells = 0;
  double speed = unset;  ///< of the steady state compared [rad/s]
  double displacement = unset,
         inner_ring_rise = unset;  ///< minus the value of the other cells [m], [K]
  double front_force = unset;      ///< [N]
  [[nodiscard]] bool known() const { return other_cells > 0; }
};

/// A steady state, or why there is none.
struct SteadyState {
  spindle::Inputs inputs;
  spindle::Moment moment;
  spindle::Report report;
  double axial_stiffness = unset;  ///< of the warm sets [N/m]
  /// Values of each bearing, front set first; empty where there is none.
  std::vector<bearing::BearingInSet> bearings = {};
};

/// A column of a run with its value, in the unit of its name.
struct RunColumn {
  std::string name;
  double value;
};

/// Data of one moment in files and pages; all names, whatever the moment has.
[[nodiscard]] std::vector<RunColumn> run_columns(const model::Model& model,
                                                 const spindle::Inputs& inputs,
                                                 const spindle::Moment& moment);

/// `run.csv`: a row for each row of the programme that was reached. `model_text` is that of the
/// file.
[[nodiscard]] std::string spindle_run_text(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, std::string_view model_text);
[[nodiscard]] std::string spindle_run_json(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, const MeshEstimate& mesh,
                                           const model::Findings& findings = {});
/// Rows of several speeds, with the same columns.
[[nodiscard]] std::string spindle_steady_text(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              std::string_view model_text);
[[nodiscard]] std::string spindle_steady_json(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              const MeshEstimate& mesh,
                                              const model::Findings& findings = {});
/// `field.csv`: middle of each cell, its part and temperature.
[[nodiscard]] std::string spindle_field_text(std::span<const spindle::FieldCell> cells,
                                             std::string_view name);

/// Temperatures to go on from.
[[nodiscard]] std::string spindle_state_json(const model::Model& model,
                                             const spindle::State& state);
/// Throws InputError: no JSON, no state of a spindle, or one that is not all numbers.
[[nodiscard]] spindle::State read_spindle_state(const std::string& path);
/// As above, from text; `source` stands in messages.
[[nodiscard]] spindle::State parse_spindle_state(const std::string& text,
                                                 const std::string& source);

/// "front_1": a bearing as columns name it, counted from the nose in each set; the name of a roller
/// bearing.
[[nodiscard]] std::string bearing_label(const model::Model& model, std::size_t bearing);

}  // namespace raceway::results
