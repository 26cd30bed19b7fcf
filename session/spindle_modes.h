#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "record/note.h"
#include "results/beam_results.h"
#include "session/beam_of_model.h"

namespace raceway::session {

struct ModesQuestion {
  std::vector<double> speeds{};  ///< [rad/s]
  bool warm = false;             ///< with the bearings of the steady, warm spindle
  bool coolant_on = true;        ///< of the warm spindle
  int count = 6;
  double damping_ratio = unset;                   ///< of every mode, as stated [1]
  std::optional<spindle::Unbalance> unbalance{};  ///< of which the path of the nose is wanted
  const std::atomic<bool>* cancelled = nullptr;   ///< as Simulator::stop_on()
};

/// Modes of a shaft on its bearings against speed.
struct SpindleModes {
  files::ModelFile file;
  BeamOfModel beam;
  std::vector<results::ModesAtSpeed> speeds{};
  bool warm = false, coolant_on = true;
  double damping_ratio = unset;
  model::Findings findings{};

  [[nodiscard]] bool converged() const;
  [[nodiscard]] std::vector<std::string> notes() const;
  /// The speeds that have no modes, and why, and limits that speeds pass.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string shapes_csv() const;
  [[nodiscard]] std::string page() const;
};

/// Throws text::InputError for a model whose shaft has no segments, and too many speeds.
[[nodiscard]] SpindleModes spindle_modes(const files::ModelFile& file,
                                         const ModesQuestion& question);

}  // namespace raceway::session
