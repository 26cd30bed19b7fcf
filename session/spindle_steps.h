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
  std::vector<double> speeds{};  ///< speeds in rising order [rad/s]
  /// Load steps at the nose, in rising order [N]. Each load is applied at every speed of
  /// `load_speeds`, or at all speeds if `load_speeds` is empty.
  std::vector<double> axial_loads{}, radial_loads{};
  std::vector<double> load_speeds{};  ///< speeds of the load steps, in rising order [rad/s]
  double duration = 4 * 3600.0;       ///< duration of each step [s]
  bool coolant_on = true;
  /// Names in messages: flags of the command, or arguments of a function.
  Wording wording = Wording::arguments;
  /// If this flag is set to true, the calculation throws fit::Cancelled.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Responses of a spindle to steps of speed or load, simulated or read from a file. The laws K(P)
/// and T(P) give the gain and the time constant of a thermal lag as functions of P, the friction
/// loss of all bearings at the end of the step.
struct SpindleSteps {
  std::optional<files::ModelFile> file{};  ///< empty if the responses were read without a model
  std::string source{};                    ///< name of the model file or of the imported file
  spindle::StepResponses responses{};
  spindle::PowerLaws laws{};
  std::vector<record::Note> notes{};
  /// Lubricant temperature at which the friction power of imported steps is computed [C]; NaN:
  /// temperature of the table [rig] of the model.
  double temperature_C = unset;
  bool coolant_on = true;
  bool simulated = false;  ///< true: simulated by raceway; false: imported from a file

  [[nodiscard]] const model::Model* model() const { return file ? &file->model : nullptr; }
  [[nodiscard]] bool converged() const;
  /// Returns the number of all speed steps and load steps.
  [[nodiscard]] std::size_t count() const;
  /// Returns one warning for each step whose simulation has no result. The warning gives the
  /// reason.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string csv() const;
  /// Returns the step responses as JSON. `error` is the result of superposition_of_steps(), or
  /// null.
  [[nodiscard]] std::string json(const results::Superposition* error = nullptr) const;
  [[nodiscard]] std::string page(const results::Superposition* error = nullptr,
                                 const std::string& programme = {}) const;
};

/// Simulates the steps. Throws text::InputError if no speed is above 0, for too many speeds, and
/// for `load_speeds` without a load step. Throws std::invalid_argument if the model is not a
/// spindle.
[[nodiscard]] SpindleSteps simulated_steps(Messages& messages, const files::ModelFile& file,
                                           const StepQuestion& question);

/// Returns step responses from imported load cases. `file` is the model of the spindle, or null. If
/// a load case contains a speed but no power, the power is calculated from the friction of the
/// model at the lubricant temperature `temperature_C` [C]. NaN means the temperature of the table
/// [rig] of the model. If `file` is null, throws text::InputError for a load case without power.
[[nodiscard]] SpindleSteps imported_steps(const std::vector<files::LoadCase>& cases,
                                          const std::string& source, const files::ModelFile* file,
                                          double temperature_C);

/// Options for a correction made from step responses.
struct StepCorrectionQuestion {
  /// Form of the laws for gain K(P) and time constant T(P) as functions of the power P: "curve",
  /// "power" or "line".
  std::string law = "curve";
  std::string lags = "auto";  ///< number of lags: "one", "two" or "auto"
  /// Names in notes: flags of the command, or arguments of a function.
  Wording wording = Wording::arguments;
  /// If this flag is set to true, the calculation throws fit::Cancelled.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Returns the correction from the step responses. Throws the same exceptions as
/// results::step_model().
[[nodiscard]] correction::Model correction_of_steps(Messages& messages, const SpindleSteps& steps,
                                                    const StepCorrectionQuestion& question);

/// Returns the names of the channels that a correction contains for the load steps of a
/// StepQuestion.
[[nodiscard]] std::vector<std::string> load_channels(const StepQuestion& question);

/// Compares the displacements from a correction, which was made from step responses, with a full
/// simulation of the spindle. `programme` is a record with the speeds and loads over time. `steps`
/// must contain a model file. Throws std::invalid_argument if the model is not a spindle, and the
/// exceptions of results::superposition().
[[nodiscard]] results::Superposition superposition_of_steps(
    Messages& messages, const SpindleSteps& steps, const correction::Model& correction,
    const Source& programme, const std::atomic<bool>* cancelled = nullptr);

}  // namespace raceway::session
