#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "record/note.h"
#include "results/beam_results.h"
#include "session/beam_of_model.h"
#include "session/wording.h"
#include "text/number_range.h"

namespace raceway::session {

inline constexpr text::NumberRange at_range{0.0, 1e5, "mm"};
inline constexpr text::NumberRange moment_load_range{-1e5, 1e5, "N m"};

struct DeflectionQuestion {
  double force = 0.0;  ///< radial or axial force [N]; an axial force is positive towards the tool
  bool axial = false;  ///< true: the force is axial; false: it is radial
  /// Axial force in addition to a radial force, positive towards the tool [N].
  double axial_force = 0.0;
  /// Moment at the position of the force [N m]; positive if it turns the shaft like a positive
  /// radial force between this position and the tool.
  double moment = 0.0;
  double at = 0.0;         ///< distance of the force behind the nose face [m]
  double speed = 0.0;      ///< shaft speed [rad/s]
  bool warm = false;       ///< true: the spindle is warm, with its preload at steady state
  bool coolant_on = true;  ///< true: the coolant of the warm spindle is on
  Wording wording = Wording::arguments;          ///< names in error messages: flags or arguments
  const std::atomic<bool>* cancelled = nullptr;  ///< if true, the calculation throws fit::Cancelled
};

/// Throws text::InputError if `force` and `moment` are both zero, and if an axial force is given
/// with a moment or with `axial_force`.
void check(const DeflectionQuestion& question);

/// Deflection of a shaft under a force.
struct SpindleDeflection {
  files::ModelFile file;
  BeamOfModel beam;
  results::DeflectionResult result{};
  bool warm = false, coolant_on = true;
  model::Findings findings{};

  [[nodiscard]] bool converged() const { return result.converged(); }
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Returns a warning with the reason if there is no result, otherwise a warning for each limit
  /// that the result exceeds.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
};

/// Computes the deflection. Throws the same exceptions as check(), and text::InputError for a model
/// without shaft segments and for a shaft that bends too far for beam theory.
[[nodiscard]] SpindleDeflection spindle_deflection(const files::ModelFile& file,
                                                   const DeflectionQuestion& question);

}  // namespace raceway::session
