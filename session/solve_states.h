#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "bearing/solve.h"
#include "files/model_file.h"
#include "model/band.h"
#include "session/messages.h"

namespace raceway::session {

/// Numbers of a caller, read where they stand: by dimension the bytes from one to the next, 0 where
/// one number holds for all. Without data the model says.
struct NumberArray {
  const char* data = nullptr;
  std::vector<std::ptrdiff_t> strides{};

  [[nodiscard]] bool given() const { return data != nullptr; }
};

/// Operating points side by side, as arrays of one shape in the units of files.
struct StateArrays {
  std::vector<std::size_t> shape;  ///< empty: one state
  NumberArray speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{}, moment_y_Nmm{},
      moment_z_Nmm{};

  [[nodiscard]] std::size_t size() const;
};

/// Results of states, in the order of their arrays with the last dimension fastest.
struct SolvedStates {
  std::vector<std::string> columns;  ///< names with their units; friction_torque_Nmm is the first
  std::vector<double> values;        ///< one column behind the other; NaN where there is no value
  std::vector<bearing::SolveStatus> status;
};

/// Columns that solve_states() gives for a model.
[[nodiscard]] std::vector<std::string> state_columns(const model::Model& model);

/// Solves a bearing, or the sets on a shaft (axial loads are then external ones), at many states,
/// on all cores. Neither the number of threads nor the other states change a digit.
///
/// `columns`: names of the requested columns; all where empty. With a `band` of the model its
/// columns (band_columns()) follow. Loads and temperatures that are not given come from the model.
/// Throws text::InputError: no speed, no load, a number out of its range (with its place in the
/// array), an unknown column, radial loads or moments on a shaft; Cancelled where `cancelled` is
/// set meanwhile. Memory: what is returned, and a block per thread.
[[nodiscard]] SolvedStates solve_states(Messages& messages, const files::ModelFile& file,
                                        const StateArrays& states,
                                        const std::vector<std::string>& columns = {},
                                        const std::atomic<bool>* cancelled = nullptr,
                                        const model::Band* band = nullptr);

/// All columns of one state by itself, with the 15 digits that `raceway solve` shows, with notes on
/// it. Many states are solved side by side; docs/speed.md gives the difference.
/// Throws as solve_states(), and for more than one state.
[[nodiscard]] SolvedStates solve_state(Messages& messages, const files::ModelFile& file,
                                       const StateArrays& states,
                                       const model::Band* band = nullptr);

/// The operating point of arrays of one number each; throws as solve_states(), and for more.
[[nodiscard]] bearing::OperatingPoint single_state(Messages& messages, const files::ModelFile& file,
                                                   const StateArrays& states);

/// Readings of a rig at states: the friction torque of all its bearings, as its sensor shows it.
struct PredictedStates {
  std::vector<double> reading_Nmm;           ///< NaN where there is none
  std::vector<bearing::SolveStatus> status;  ///< `not_finite` where only the reading is no number
};

/// Solves the readings of a rig at many states; no further column, so that balls are solved for
/// only where the model needs them. Otherwise as solve_states(). Throws text::InputError also for a
/// shaft, and for an effect that needs an input which states lack, a time or a temperature of a
/// ring.
[[nodiscard]] PredictedStates predict_states(Messages& messages, const files::ModelFile& file,
                                             const StateArrays& states);

}  // namespace raceway::session
