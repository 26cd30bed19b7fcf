#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "record/note.h"
#include "results/spindle_results.h"

/// Steady states of a spindle, as they are asked for.
namespace raceway::session {

/// Throws text::InputError if the model does not describe a spindle.
void require_spindle(const files::ModelFile& file);

/// Throws text::InputError, with the name of the file, for one that cannot be mounted or meshed.
[[nodiscard]] spindle::Simulator simulator_of(const files::ModelFile& file);

/// The steady state under these inputs with the cells of the model, compared with the next finer
/// ones (of the finest, the next coarser). Not known of a network, and where either has none.
[[nodiscard]] results::MeshEstimate mesh_estimate(const model::Model& model,
                                                  const spindle::Inputs& inputs,
                                                  const std::atomic<bool>* cancelled = nullptr);
/// In words, a line.
[[nodiscard]] std::string words(const results::MeshEstimate& mesh);

struct SteadyQuestion {
  std::vector<double> speeds{};        ///< [rad/s]
  double ambient_temperature = unset;  ///< [K]; NaN: of the model
  bool coolant_on = true;
  double axial_load = unset;   ///< at the nose, towards the tool [N]; NaN: of the model
  double radial_load = 0.0;    ///< at the nose, in the direction of y [N]
  double moment = 0.0;         ///< there, in the sense of a force further in front [N m]
  double belt_force = unset;   ///< [N]; NaN: of the model
  double motor_power = unset;  ///< that the motor takes [W], for formulas of heat
  bool assumptions = false;    ///< whether those that matter most are wanted
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Steady states, one for each speed.
struct SteadySpindle {
  files::ModelFile file;
  std::vector<results::SteadyState> states{};
  std::vector<std::string> roller_notes{};  ///< what to know of roller bearings
  results::MeshEstimate mesh{};
  results::Assumptions assumptions{};  ///< at the last speed that has a state
  model::Findings findings{};
  spindle::State end{};                     ///< of the last speed; nothing where it has none
  std::vector<spindle::FieldCell> field{};  ///< the same, cell by cell

  [[nodiscard]] bool converged() const;
  [[nodiscard]] std::vector<std::string> notes() const;
  /// The speeds that have no steady state, and why, and limits that the others pass.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json(bool with_assumptions = true) const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
  [[nodiscard]] std::string end_state() const;
  [[nodiscard]] std::string field_csv() const;
};

/// Throws text::InputError for a model that is no spindle.
[[nodiscard]] SteadySpindle steady_spindle(const files::ModelFile& file,
                                           const SteadyQuestion& question);

}  // namespace raceway::session
