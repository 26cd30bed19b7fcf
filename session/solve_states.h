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

/// Array of doubles in the memory of the caller; the numbers are not copied. Each stride is the
/// number of bytes from one double to the next along one dimension. With a stride of 0, all doubles
/// along this dimension are equal. If `data` is null, the array is not given. A load or a
/// temperature then comes from the model, and a moment is 0. The speeds must be given.
struct NumberArray {
  const char* data = nullptr;
  std::vector<std::ptrdiff_t> strides{};

  [[nodiscard]] bool given() const { return data != nullptr; }
};

/// Operating points as arrays that all have the same shape, in the units of files.
struct StateArrays {
  std::vector<std::size_t> shape;  ///< shape of the arrays; an empty shape means a single state
  NumberArray speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{}, moment_y_Nmm{},
      moment_z_Nmm{};

  [[nodiscard]] std::size_t size() const;
};

/// Results of solve_states(). The order of the states is the order in the input arrays: the last
/// dimension varies fastest.
struct SolvedStates {
  std::vector<std::string> columns;  ///< names with units; the first is friction_torque_Nmm
  std::vector<double> values;        ///< [columns x states]; NaN for a missing value
  std::vector<bearing::SolveStatus> status;
};

/// Returns the names of all columns that solve_states() can compute for a model without a
/// confidence band.
[[nodiscard]] std::vector<std::string> state_columns(const model::Model& model);

/// Solves a bearing, or the bearing sets on a shaft, at many states. The calculation uses all
/// cores. On a shaft, axial loads are external loads. The results of a state do not depend on the
/// number of threads or on any other state.
///
/// `columns` lists the requested columns; an empty list means all columns. If the confidence band
/// `band` is given, the result also has the columns of the band (band_columns()), after the
/// requested columns. Loads and temperatures that are not given come from the model. Throws
/// text::InputError in these cases:
///   - The speeds are missing, or neither the arrays nor the model give an axial load.
///   - A number is outside its range. The message gives the indices of the number in the array.
///   - A column is unknown.
///   - Radial loads or moments are given for a shaft.
///
/// Throws fit::Cancelled if `cancelled` is set during the calculation.
[[nodiscard]] SolvedStates solve_states(Messages& messages, const files::ModelFile& file,
                                        const StateArrays& states,
                                        const std::vector<std::string>& columns = {},
                                        const std::atomic<bool>* cancelled = nullptr,
                                        const model::Band* band = nullptr);

/// Solves a single state and returns all columns. Sends notes on the results to `messages`. The
/// values have the same 15 digits as the output of `raceway solve`. solve_states() calculates
/// several states together, so its values may differ slightly from these values (docs/speed.md).
/// Throws the same exceptions as solve_states(), and text::InputError unless there is exactly one
/// state.
[[nodiscard]] SolvedStates solve_state(Messages& messages, const files::ModelFile& file,
                                       const StateArrays& states,
                                       const model::Band* band = nullptr);

/// Converts arrays with a single state to an operating point. Throws the same exceptions as
/// solve_states(), and text::InputError unless there is exactly one state.
[[nodiscard]] bearing::OperatingPoint single_state(Messages& messages, const files::ModelFile& file,
                                                   const StateArrays& states);

/// Predicted readings of a rig: the friction torque of all bearings as the sensor shows it,
/// including effects that change the reading.
struct PredictedStates {
  std::vector<double> reading_Nmm;  ///< one reading for each state; NaN if there is no prediction
  /// One status for each state; `not_finite` if the solver converged but the reading is NaN.
  std::vector<bearing::SolveStatus> status;
};

/// Predicts the readings of a rig at many states. The arguments are as in solve_states(). The
/// function solves the equilibrium of the balls only if the friction law or an effect needs this
/// equilibrium. Also throws text::InputError for a shaft, and if an effect needs an input that is
/// not in StateArrays, such as a time or a ring temperature.
[[nodiscard]] PredictedStates predict_states(Messages& messages, const files::ModelFile& file,
                                             const StateArrays& states);

}  // namespace raceway::session
