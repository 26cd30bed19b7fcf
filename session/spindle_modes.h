#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "io/beam_results.h"
#include "io/model_file.h"
#include "session/beam_of_model.h"

namespace raceway::session {

struct ModesQuestion {
  std::vector<double> speeds{};  ///< [rad/s]
  bool warm = false;             ///< with the bearings of the steady, warm spindle
  bool coolant_on = true;        ///< of the warm spindle
  int count = 6;
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Modes of a shaft on its bearings against speed.
struct SpindleModes {
  io::ModelFile file;
  BeamOfModel beam;
  std::vector<io::ModesAtSpeed> speeds{};
  bool warm = false;

  [[nodiscard]] bool converged() const;
  [[nodiscard]] std::vector<std::string> notes() const;
  /// The speeds that have no modes, and why.
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string shapes_csv() const;
  [[nodiscard]] std::string page() const;
};

/// Throws io::InputError for a model whose shaft has no segments, and too many speeds.
[[nodiscard]] SpindleModes spindle_modes(const io::ModelFile& file, const ModesQuestion& question);

}  // namespace raceway::session
