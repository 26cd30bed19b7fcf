#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/judgement.h"
#include "model/model.h"
#include "spindle/film.h"
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

/// A number that a model file leaves to its default, and what its usual spread does to the nose.
struct Assumption {
  std::string name;                  ///< "bearing.lubricant_conductance_W_K"
  double value = unset;              ///< in the unit of its name
  double spread = unset;             ///< either way
  double low = unset, high = unset;  ///< displacement at value - spread and + spread [m]; NaN: none
};

/// The assumed numbers that matter most for a steady state of a spindle.
struct Assumptions {
  double speed = unset;            ///< [rad/s]
  double displacement = unset;     ///< of the nose there [m]
  std::size_t assumed = 0;         ///< numbers that were varied
  std::vector<Assumption> most{};  ///< at most five, the largest change first
  [[nodiscard]] bool known() const { return !most.empty(); }
};

/// A steady state, or why there is none.
struct SteadyState {
  spindle::Inputs inputs;
  spindle::Moment moment;
  spindle::Report report;
  double axial_stiffness = unset;  ///< of the warm sets [N/m]
  /// Values of each bearing, front set first; empty where there is none.
  std::vector<bearing::BearingInSet> bearings = {};
  std::optional<spindle::ChannelFlow> coolant = {};  ///< none where it stands
  std::vector<spindle::SeatsOfBearing> seats = {};   ///< as Moment::bearings; none in a network
  std::vector<spindle::ShaftPlace> shaft = {};       ///< from the nose to the rear end
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

/// `run.csv`: a row for each row of the programme that was reached, and one where the run ended
/// early. `model_text` is the text of the file.
[[nodiscard]] std::string spindle_run_text(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, std::string_view model_text);
[[nodiscard]] std::string spindle_run_json(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, const MeshEstimate& mesh,
                                           const model::Findings& findings = {},
                                           const Assumptions& assumptions = {});
/// Rows of several speeds, with the same columns.
[[nodiscard]] std::string spindle_steady_text(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              std::string_view model_text);
[[nodiscard]] std::string spindle_steady_json(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              const MeshEstimate& mesh,
                                              const model::Findings& findings = {},
                                              const Assumptions& assumptions = {});
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
