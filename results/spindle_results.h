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

/// Writes results of a spindle simulation as CSV and JSON; names of keys and columns contain their
/// units.
namespace raceway::results {

/// Difference between results with the chosen cells and with other cells.
struct MeshEstimate {
  std::size_t cells = 0, other_cells = 0;
  double speed = unset;  ///< speed of the compared steady state [rad/s]
  double displacement = unset,
         inner_ring_rise = unset;  ///< chosen cells minus the other cells [m], [K]
  double front_force = unset;      ///< [N]
  [[nodiscard]] bool known() const { return other_cells > 0; }
};

/// A default value of a model, and the influence of its usual spread on the displacement of the
/// nose.
struct Assumption {
  std::string name;       ///< "bearing.lubricant_conductance_W_K"
  double value = unset;   ///< in the unit of the name
  double spread = unset;  ///< possible error in either direction
  /// Displacement at value - spread and value + spread [m]; NaN: no result.
  double low = unset, high = unset;
};

/// Default values with the largest influence on a steady state of a spindle.
struct Assumptions {
  double speed = unset;            ///< [rad/s]
  double displacement = unset;     ///< displacement of the nose at this speed [m]
  std::size_t assumed = 0;         ///< number of default values that were varied
  std::vector<Assumption> most{};  ///< at most five, the largest change first
  [[nodiscard]] bool known() const { return !most.empty(); }
};

/// A steady state, or the reason why there is none.
struct SteadyState {
  spindle::Inputs inputs;
  spindle::Moment moment;
  spindle::Report report;
  double axial_stiffness = unset;  ///< axial stiffness of the warm sets [N/m]
  /// Values of each bearing, front set first; empty if there are no values.
  std::vector<bearing::BearingInSet> bearings = {};
  /// Flow of each circuit in the order of model::Spindle::channels(); empty if the coolant of the
  /// circuit does not flow.
  std::vector<std::optional<spindle::ChannelFlow>> channels = {};
  /// seats in the order of Moment::bearings; empty for a network
  std::vector<spindle::SeatsOfBearing> seats = {};
  std::vector<spindle::SurfaceState> surfaces = {};  ///< joints and surfaces, without the seats
  std::vector<spindle::ShaftPlace> shaft = {};       ///< from the nose to the rear end
  std::vector<spindle::SectionStress> stress = {};   ///< stress of shaft and rings
};

/// Returns the section with the largest von Mises stress; null for an empty list.
[[nodiscard]] const spindle::SectionStress* largest_stress(
    std::span<const spindle::SectionStress> sections);

/// A column of a run, with the value in the unit of the column name.
struct RunColumn {
  std::string name;
  double value;
};

/// Returns all columns of one moment for files and pages, including those without a value.
[[nodiscard]] std::vector<RunColumn> run_columns(const model::Model& model,
                                                 const spindle::Inputs& inputs,
                                                 const spindle::Moment& moment);

/// Returns `run.csv`: one row for each completed row of the programme, and one more row if the run
/// ends early. `model_text` is the text of the model file.
[[nodiscard]] std::string spindle_run_text(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, std::string_view model_text);
[[nodiscard]] std::string spindle_run_json(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, const MeshEstimate& mesh,
                                           const model::Findings& findings = {},
                                           const Assumptions& assumptions = {});
/// Returns the steady states of several speeds, with the columns of `run.csv` except time_s, and
/// with axial stiffness and status.
[[nodiscard]] std::string spindle_steady_text(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              std::string_view model_text);
[[nodiscard]] std::string spindle_steady_json(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              const MeshEstimate& mesh,
                                              const model::Findings& findings = {},
                                              const Assumptions& assumptions = {});
/// Returns `field.csv`: middle, part and temperature of each cell.
[[nodiscard]] std::string spindle_field_text(std::span<const spindle::FieldCell> cells,
                                             std::string_view name);

/// Returns the temperatures of a spindle as a saved state. A simulation can start from this state.
[[nodiscard]] std::string spindle_state_json(const model::Model& model,
                                             const spindle::State& state);
/// Throws InputError if the file is not JSON, if it is not a state of a spindle, or if a value is
/// not a number.
[[nodiscard]] spindle::State read_spindle_state(const std::string& path);
/// Reads a state from text; `source` appears in messages.
[[nodiscard]] spindle::State parse_spindle_state(const std::string& text,
                                                 const std::string& source);

/// Returns the name of a coolant circuit, "coolant" for the first one.
[[nodiscard]] std::string circuit_name(const model::Model& model, std::size_t circuit);
/// Returns the name of a bearing in columns: "front_1", counted from the nose in each set, or the
/// name of a roller bearing.
[[nodiscard]] std::string bearing_label(const model::Model& model, std::size_t bearing);

}  // namespace raceway::results
