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

/// Writes results of a spindle simulation as CSV and JSON. The names of keys and columns contain
/// the units.
namespace raceway::results {

/// Mesh check: the steady state is computed with the chosen mesh and with another mesh. The members
/// `displacement`, `inner_ring_rise` and `front_force` are the result with the chosen mesh minus
/// the result with the other mesh.
struct MeshEstimate {
  std::size_t cells = 0, other_cells = 0;
  double speed = unset;  ///< speed of both steady states [rad/s]
  double displacement = unset,
         inner_ring_rise = unset;  ///< nose displacement [m], hottest inner ring temperature [K]
  double front_force = unset;      ///< force of the front set [N]
  [[nodiscard]] bool known() const { return other_cells > 0; }
};

/// Assumed value of a model, and the influence of its possible error on the nose displacement. An
/// assumed value is a default, or a value that the model file marks as assumed.
struct Assumption {
  std::string name;       ///< table, key and unit, such as "bearing.lubricant_conductance_W_K"
  double value = unset;   ///< value in the model, in the unit at the end of `name`
  double spread = unset;  ///< possible error in both directions, in the unit at the end of `name`
  /// Nose displacement at value - spread and at value + spread [m]; NaN if there is no result.
  double low = unset, high = unset;
  bool low_allowed = true, high_allowed = true;  ///< false: a model file must not have this value
};

/// Assumed values with the largest influence on the nose displacement in a steady state.
struct Assumptions {
  double speed = unset;            ///< [rad/s]
  double displacement = unset;     ///< displacement of the nose at this speed [m]
  std::size_t assumed = 0;         ///< number of assumed values that were varied
  std::vector<Assumption> most{};  ///< at most five, largest influence first
  [[nodiscard]] bool known() const { return !most.empty(); }
};

/// Results of a steady state. Without a solution, `report` gives the reason.
struct SteadyState {
  spindle::Inputs inputs;
  spindle::Moment moment;
  spindle::Report report;
  double axial_stiffness = unset;  ///< axial stiffness of the warm bearing sets [N/m]
  /// Equilibrium of each bearing, front set first; empty without an equilibrium.
  std::vector<bearing::BearingInSet> bearings = {};
  /// Flow in each coolant circuit, in the order of model::Spindle::channels(). An entry is empty if
  /// the coolant does not flow.
  std::vector<std::optional<spindle::ChannelFlow>> channels = {};
  /// Seats of the bearing rings, in the order of Moment::bearings; empty for a thermal network.
  std::vector<spindle::SeatsOfBearing> seats = {};
  /// Heat transfer at all joints and surfaces except the ring seats; empty for a thermal network.
  std::vector<spindle::SurfaceState> surfaces = {};
  /// Axial displacements of the shaft, from nose to rear end.
  std::vector<spindle::ShaftPlace> shaft = {};
  std::vector<spindle::SectionStress> stress = {};  ///< stress of shaft and rings
};

/// Returns the section with the largest von Mises stress; null if `sections` is empty.
[[nodiscard]] const spindle::SectionStress* largest_stress(
    std::span<const spindle::SectionStress> sections);

/// Name of a column of run.csv and its value at one time, in the unit at the end of `name`.
struct RunColumn {
  std::string name;
  double value;
};

/// Returns all columns of run.csv at one time except time_s. Columns without a value are NaN.
[[nodiscard]] std::vector<RunColumn> run_columns(const model::Model& model,
                                                 const spindle::Inputs& inputs,
                                                 const spindle::Moment& moment);

/// Returns the text of `run.csv`, with one row for each row of the speed programme that the
/// simulation reached. If the simulation stopped early, the last row contains the results at the
/// time of the stop. `model_text` is the text of the model file.
[[nodiscard]] std::string spindle_run_text(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, std::string_view model_text);
[[nodiscard]] std::string spindle_run_json(const model::Model& model,
                                           std::span<const spindle::ProfileRow> profile,
                                           const spindle::Run& run, const MeshEstimate& mesh,
                                           const model::Findings& findings = {},
                                           const Assumptions& assumptions = {});
/// Returns the steady states at several speeds as CSV, with the columns of `run.csv` except time_s,
/// and with columns for axial stiffness and status.
[[nodiscard]] std::string spindle_steady_text(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              std::string_view model_text);
[[nodiscard]] std::string spindle_steady_json(const model::Model& model,
                                              std::span<const SteadyState> states,
                                              const MeshEstimate& mesh,
                                              const model::Findings& findings = {},
                                              const Assumptions& assumptions = {});
/// Returns the text of `field.csv`. Each row gives the axial position and the radius of the centre
/// of one cell, the part of the spindle that contains the cell, and the temperature.
[[nodiscard]] std::string spindle_field_text(std::span<const spindle::FieldCell> cells,
                                             std::string_view name);

/// Returns the temperatures of all cells of a spindle as JSON. A later simulation can start from
/// these temperatures.
[[nodiscard]] std::string spindle_state_json(const model::Model& model,
                                             const spindle::State& state);
/// Reads a state from a file that contains the text of spindle_state_json(). Throws InputError if
/// the file is not JSON, does not contain a spindle state, has an unsupported format number, or has
/// a value that is missing or outside its range.
[[nodiscard]] spindle::State read_spindle_state(const std::string& path);
/// Reads a state from `text`, as written by spindle_state_json(). Error messages name `source` as
/// the file.
[[nodiscard]] spindle::State parse_spindle_state(const std::string& text,
                                                 const std::string& source);

/// Returns the name of a coolant circuit. The first circuit has the name "coolant".
[[nodiscard]] std::string circuit_name(const model::Model& model, std::size_t circuit);
/// Returns the name of a bearing in column names. The bearings of a set are numbered from the nose,
/// such as "front_1" and "front_2". A roller bearing has its name in the model.
[[nodiscard]] std::string bearing_label(const model::Model& model, std::size_t bearing);

}  // namespace raceway::results
