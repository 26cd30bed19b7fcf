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
  double force = 0.0;        ///< [N]; axial: positive towards the tool
  bool axial = false;        ///< the force; else it is radial
  double axial_force = 0.0;  ///< in addition to a radial one, positive towards the tool [N]
  double moment = 0.0;  ///< at its place, positive as the force further in front, at the tool [N m]
  double at = 0.0;      ///< behind the nose face [m]
  double speed = 0.0;   ///< [rad/s]
  bool warm = false;    ///< with the preload of the steady, warm spindle
  bool coolant_on = true;                        ///< of the warm spindle
  Wording wording = Wording::arguments;          ///< of errors
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Throws text::InputError where nothing pushes, or loads do not go together.
void check(const DeflectionQuestion& question);

/// A shaft under a force.
struct SpindleDeflection {
  files::ModelFile file;
  BeamOfModel beam;
  results::DeflectionResult result{};
  bool warm = false, coolant_on = true;
  model::Findings findings{};

  [[nodiscard]] bool converged() const { return result.converged(); }
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Reason why there is none, or limits that it passes.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
};

/// Throws text::InputError as check(), for a model whose shaft has no segments, and for a shaft
/// that would bend beyond what a beam is.
[[nodiscard]] SpindleDeflection spindle_deflection(const files::ModelFile& file,
                                                   const DeflectionQuestion& question);

}  // namespace raceway::session
