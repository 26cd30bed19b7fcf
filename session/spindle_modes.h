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
  std::vector<double> speeds{};  ///< shaft speeds [rad/s]
  /// True: the modes are calculated with the bearing stiffness of the warm spindle at steady state;
  /// false: with the bearing stiffness of the cold spindle.
  bool warm = false;
  bool coolant_on = true;        ///< true: the coolant of the warm spindle is on
  int count = 6;                 ///< number of modes at each speed
  double damping_ratio = unset;  ///< damping ratio assigned to every mode [1]
  /// Unbalance that makes the nose whirl. If no unbalance is given, the orbit of the nose is not
  /// computed.
  std::optional<spindle::Unbalance> unbalance{};
  /// If this flag is set to true, the calculation throws fit::Cancelled.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Natural vibration modes of a shaft on its bearings, at several speeds.
struct SpindleModes {
  files::ModelFile file;
  BeamOfModel beam;
  std::vector<results::ModesAtSpeed> speeds{};
  bool warm = false, coolant_on = true;
  double damping_ratio = unset;
  model::Findings findings{};

  [[nodiscard]] bool converged() const;
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Returns one warning for each speed without modes, with the reason, and one for each exceeded
  /// limit.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string shapes_csv() const;
  [[nodiscard]] std::string page() const;
};

/// Computes the modes. Throws text::InputError for a model without shaft segments, for too many
/// speeds, and for an invalid damping ratio or unbalance.
[[nodiscard]] SpindleModes spindle_modes(const files::ModelFile& file,
                                         const ModesQuestion& question);

}  // namespace raceway::session
