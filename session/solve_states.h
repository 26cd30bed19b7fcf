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

/// Array of doubles that belongs to the caller and is read without a copy. Each stride is the
/// number of bytes from one double to the next along one dimension; 0 repeats the double along this
/// dimension. If `data` is null, the array is not given: a load or a temperature then comes from
/// the model, and a moment is 0. The speeds must be given.
struct NumberArray {
  const char* data = nullptr;
  std::vector<std::ptrdiff_t> strides{};

  [[nodiscard]] bool given() const { return data != nullptr; }
};

/// Operating points as arrays of one shape, in the units of files.
struct StateArrays {
  std::vector<std::size_t> shape;  ///< shape of the arrays; empty: one state
  NumberArray speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{}, moment_y_Nmm{},
      moment_z_Nmm{};

  [[nodiscard]] std::size_t size() const;
};

/// Results of states, in the order of the states in the input arrays: the last dimension varies
/// fastest.
struct SolvedStates {
  std::vector<std::string> columns;  ///< names with their units; friction_torque_Nmm is the first
  std::vector<double> values;        ///< [columns x states]; NaN for a missing value
  std::vector<bearing::SolveStatus> status;
};

/// Returns the columns of solve_states() for a model, without band columns.
[[nodiscard]] std::vector<std::string> state_columns(const model::Model& model);

/// Solves a bearing or the sets on a shaft at many states on all cores. On a shaft, axial loads are
/// external loads. The results of a state do not depend on the number of threads or on any other
/// state.
///
/// `columns` lists the requested columns; an empty list means all columns. If `band` is given, the
/// columns of the band follow (band_columns()). Loads and temperatures that are not given come from
/// the model. Throws text::InputError for a missing speed, for a load that neither the arrays nor
/// the model give, for a number out of its range (with its place in the array), for an unknown
/// column, and for radial loads or moments on a shaft. Throws fit::Cancelled if `cancelled` is set
/// during the calculation. The function needs memory for the returned arrays and for one block of
/// states per thread.
[[nodiscard]] SolvedStates solve_states(Messages& messages, const files::ModelFile& file,
                                        const StateArrays& states,
                                        const std::vector<std::string>& columns = {},
                                        const std::atomic<bool>* cancelled = nullptr,
                                        const model::Band* band = nullptr);

/// Solves a single state and returns all columns with notes. The values have the same 15 digits as
/// the output of `raceway solve`. solve_states() solves several points together in SIMD lanes, so
/// its values may differ slightly from these values (docs/speed.md). Throws the same exceptions as
/// solve_states(), and text::InputError unless there is exactly one state.
[[nodiscard]] SolvedStates solve_state(Messages& messages, const files::ModelFile& file,
                                       const StateArrays& states,
                                       const model::Band* band = nullptr);

/// Returns the operating point of arrays that contain a single state. Throws the same exceptions as
/// solve_states(), and text::InputError unless there is exactly one state.
[[nodiscard]] bearing::OperatingPoint single_state(Messages& messages, const files::ModelFile& file,
                                                   const StateArrays& states);

/// Predicted readings of a rig: the friction torque of all bearings, with the effects on the
/// sensor.
struct PredictedStates {
  std::vector<double> reading_Nmm;  ///< [states]; NaN for a state without a prediction
  /// [states]; `not_finite` if the solver converged but the reading is NaN.
  std::vector<bearing::SolveStatus> status;
};

/// Predicts the readings of a rig at many states. The function computes no other columns. The
/// equilibrium of the balls is solved only if the model needs it. Arguments and results are
/// otherwise as in solve_states(). Also throws text::InputError for a shaft, and for an effect that
/// needs a time or a ring temperature, because states do not contain these inputs.
[[nodiscard]] PredictedStates predict_states(Messages& messages, const files::ModelFile& file,
                                             const StateArrays& states);

}  // namespace raceway::session
