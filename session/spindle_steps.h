#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "correction/model.h"
#include "files/model_file.h"
#include "files/step_import.h"
#include "record/note.h"
#include "results/step_correction.h"
#include "results/superposition.h"
#include "session/messages.h"
#include "session/source.h"
#include "session/wording.h"
#include "spindle/power_laws.h"
#include "spindle/step_response.h"
#include "text/number_range.h"

namespace raceway::session {

inline constexpr text::NumberRange step_hours_range{0.1, 1000.0, "h"};

struct StepQuestion {
  std::vector<double> speeds{};  ///< [rad/s], rising
  /// Loads at the nose that step [N], rising, each at every speed of `load_speeds`, or at all
  /// speeds where that is empty.
  std::vector<double> axial_loads{}, radial_loads{};
  std::vector<double> load_speeds{};  ///< [rad/s], rising
  double duration = 4 * 3600.0;       ///< of each step [s]
  bool coolant_on = true;
  Wording wording = Wording::arguments;          ///< of errors and notes
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Step responses of a spindle, simulated or read, with the laws K(P) and T(P) of all of them.
struct SpindleSteps {
  std::optional<files::ModelFile> file{};  ///< none where they were read without a model
  std::string source{};                    ///< what they are of
  spindle::StepResponses responses{};
  spindle::PowerLaws laws{};
  std::vector<record::Note> notes{};
  double temperature_C = unset;  ///< of the lubricant, for the power of those that were read
  bool coolant_on = true;
  bool simulated = false;

  [[nodiscard]] const model::Model* model() const { return file ? &file->model : nullptr; }
  [[nodiscard]] bool converged() const;
  /// Number of step responses, of speeds and of loads.
  [[nodiscard]] std::size_t count() const;
  /// The steps that have no response, and why.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string csv() const;
  /// `error` of a correction over a programme, null where none was asked for.
  [[nodiscard]] std::string json(const results::Superposition* error = nullptr) const;
  [[nodiscard]] std::string page(const results::Superposition* error = nullptr,
                                 const std::string& programme = {}) const;
};

/// Throws text::InputError without a speed above 0 or with too many, and for speeds of loads
/// without a load; std::invalid_argument for a model that is no spindle.
[[nodiscard]] SpindleSteps simulated_steps(Messages& messages, const files::ModelFile& file,
                                           const StepQuestion& question);

/// Step responses from load cases that were read; `file` may be null. Cases with a speed alone have
/// the power of the model there, at a temperature of its lubricant [C]; NaN: the temperature of its
/// rig.
[[nodiscard]] SpindleSteps imported_steps(const std::vector<files::LoadCase>& cases,
                                          const std::string& source, const files::ModelFile* file,
                                          double temperature_C);

/// Options of a correction made of step responses.
struct StepCorrectionQuestion {
  std::string law = "curve";                     ///< of K and T: "curve", "power" or "line"
  std::string lags = "auto";                     ///< delay elements: "one", "two" or "auto"
  Wording wording = Wording::arguments;          ///< of notes
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// The correction that these step responses make. Throws std::invalid_argument where they make
/// none.
[[nodiscard]] correction::Model correction_of_steps(Messages& messages, const SpindleSteps& steps,
                                                    const StepCorrectionQuestion& question);

/// Names of the channels that the loads of a question give a correction.
[[nodiscard]] std::vector<std::string> load_channels(const StepQuestion& question);

/// Compares a correction of them with the full simulation, over a programme of speeds and loads,
/// read as a spindle record. Throws std::invalid_argument as results::superposition().
[[nodiscard]] results::Superposition superposition_of_steps(
    Messages& messages, const SpindleSteps& steps, const correction::Model& correction,
    const Source& programme, const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
