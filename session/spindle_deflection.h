#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "io/beam_results.h"
#include "io/model_file.h"
#include "io/number_range.h"
#include "session/beam_of_model.h"
#include "session/wording.h"

namespace raceway::session {

inline constexpr io::NumberRange at_range{0.0, 1e5, "mm"};
inline constexpr io::NumberRange moment_load_range{-1e5, 1e5, "N m"};

struct DeflectionQuestion {
  double force = 0.0;        ///< [N]; axial: positive towards the tool
  bool axial = false;        ///< the force; else it is radial
  double axial_force = 0.0;  ///< beside a radial one, positive towards the tool [N]
  double moment = 0.0;  ///< at its place, positive as the force further in front, at the tool [N m]
  double at = 0.0;      ///< behind the nose face [m]
  double speed = 0.0;   ///< [rad/s]
  bool warm = false;    ///< with the preload of the steady, warm spindle
  bool coolant_on = true;                        ///< of the warm spindle
  Wording wording = Wording::arguments;          ///< of errors
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Throws io::InputError where nothing pushes, or loads do not go together.
void check(const DeflectionQuestion& question);

/// A shaft under a force.
struct SpindleDeflection {
  io::ModelFile file;
  BeamOfModel beam;
  io::DeflectionResult result{};
  bool warm = false;

  [[nodiscard]] bool converged() const { return result.converged(); }
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Why there is none.
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
};

/// Throws io::InputError as check(), and for a model whose shaft has no segments.
[[nodiscard]] SpindleDeflection spindle_deflection(const io::ModelFile& file,
                                                   const DeflectionQuestion& question);

}  // namespace raceway::session
