#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "record/note.h"
#include "results/spindle_results.h"

/// Computes steady states of a spindle.
namespace raceway::session {

/// Throws text::InputError if the model does not describe a spindle.
void require_spindle(const files::ModelFile& file);

/// Builds the simulator of a spindle. Throws text::InputError with the file name if the bearing
/// sets cannot be mounted or the mesh cannot be built.
[[nodiscard]] spindle::Simulator simulator_of(const files::ModelFile& file);

/// Estimates the mesh error by comparing two steady states: with the mesh of the model and with the
/// next finer mesh. If the model already uses the finest mesh, the second mesh is the next coarser
/// mesh. The estimate is empty for a thermal network, and if one of the two steady states was not
/// found.
[[nodiscard]] results::MeshEstimate mesh_estimate(const model::Model& model,
                                                  const spindle::Inputs& inputs,
                                                  const std::atomic<bool>* cancelled = nullptr);
/// Returns the mesh error as one line of text.
[[nodiscard]] std::string words(const results::MeshEstimate& mesh);

struct SteadyQuestion {
  std::vector<double> speeds{};        ///< shaft speeds [rad/s]
  double ambient_temperature = unset;  ///< ambient temperature [K]; NaN: value of the model
  bool coolant_on = true;
  /// Axial load at the nose, positive towards the tool [N]; NaN means the value of the model.
  double axial_load = unset;
  double radial_load = 0.0;  ///< radial load at the nose, in the direction of y [N]
  /// Moment at the nose [N m]; positive if it turns the shaft like a positive radial force in front
  /// of the nose.
  double moment = 0.0;
  double belt_force = unset;  ///< pull of the belt [N]; NaN: value of the model
  /// Electrical power of the motor, used in heat formulas of the model [W]; NaN: unknown.
  double motor_power = unset;
  bool assumptions = false;  ///< true: the results contain the most influential assumed values
  const std::atomic<bool>* cancelled = nullptr;  ///< if true, the calculation throws fit::Cancelled
};

/// Steady states, one for each speed.
struct SteadySpindle {
  files::ModelFile file;
  std::vector<results::SteadyState> states{};
  /// Notes on the roller bearings at the last speed, for example that the load is below the minimum
  /// load.
  std::vector<std::string> roller_notes{};
  std::string doubt{};  ///< doubt about the unit of the ambient temperature; empty if there is none
  results::MeshEstimate mesh{};
  /// Most influential assumed values of the model, at the last speed with a steady state.
  results::Assumptions assumptions{};
  model::Findings findings{};
  spindle::State end{};  ///< steady state of the last speed; empty if it was not found
  std::vector<spindle::FieldCell> field{};  ///< temperature of each cell at the last speed

  [[nodiscard]] bool converged() const;
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Returns a warning with the reason for each speed without a steady state, and a warning for
  /// each limit that a steady state exceeds.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json(bool with_assumptions = true) const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
  [[nodiscard]] std::string end_state() const;
  [[nodiscard]] std::string field_csv() const;
};

/// Computes the steady states. Throws text::InputError if the model is not a spindle, for a value
/// outside its range, for a belt force if the model has no belt, and for a load on a thermal
/// network.
[[nodiscard]] SteadySpindle steady_spindle(const files::ModelFile& file,
                                           const SteadyQuestion& question);

}  // namespace raceway::session
