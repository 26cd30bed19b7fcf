#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "friction/stribeck_table.h"
#include "model/judgement.h"
#include "record/note.h"
#include "record/record.h"
#include "results/beam_results.h"
#include "results/spindle_results.h"
#include "session/wording.h"
#include "shaft/shaft_prediction.h"

/// Every answer that commands, Python and C give, as model::Judge sees it, and every question that
/// no bearing can be asked.
namespace raceway::session {

/// The model as mounted: the pressure of the preload and the fits of the rings. The reader of
/// models has refused a preload that no steel holds.
[[nodiscard]] model::Findings judge_mounted(const files::ModelFile& file);

/// Says what of the fit of the inner rings the mounted preload has, where it stands in two places
/// of a spindle; a warning where the places differ.
[[nodiscard]] std::vector<record::Note> fit_notes(const model::Model& model);

/// Warnings among findings as notes.
[[nodiscard]] std::vector<record::Note> warnings_said(const model::Findings& findings);

/// Findings as notes: a limit of running bearings is a warning.
[[nodiscard]] std::vector<record::Note> said_of(const model::Findings& findings);

/// The sets of a shaft.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const shaft::ShaftPoint> points,
                                    std::span<const shaft::ShaftPrediction> predictions);

/// Rows of a table of a bearing or a shaft, which are judged by the names of their columns; rows of
/// rollers by their speed alone.
class JudgedColumns {
 public:
  /// The model must outlive it.
  JudgedColumns(const model::Model& model, const std::vector<std::string>& names);
  void look(const bearing::OperatingPoint& point, std::span<const double> row,
            model::Judge& judge) const;

 private:
  struct OfBearing {
    std::string place;  ///< on its shaft
    std::size_t lost = 0, inner = 0, outer = 0, load = 0, least = 0, largest = 0;
  };
  const model::Model* model_;
  std::vector<OfBearing> bearings_;
  std::size_t front_ = 0, rear_ = 0;
  double mounted_ = unset;
};

[[nodiscard]] model::Findings judge(const model::Model& model,
                                    const friction::StribeckTable& table);

/// Steady states of a spindle.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const results::SteadyState> states);

/// A spindle through a programme. Its moments have no contacts: each bearing is solved once more
/// under the largest force that it has.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const spindle::ProfileRow> profile,
                                    const spindle::Run& run);

/// A bent shaft. Throws text::InputError for one that is bent beyond what any beam is.
[[nodiscard]] model::Findings judge(const model::Model& model, const bearing::Arrangement& mounted,
                                    const results::DeflectionResult& result, Wording wording);

/// Says that states beyond the friction table of a spindle are not counted, for answers that do not
/// keep the states of bearings; nothing under another law.
[[nodiscard]] std::vector<record::Note> states_not_counted(const model::Model& model);

/// Speeds alone [rad/s].
[[nodiscard]] model::Findings judge_speeds(const model::Model& model,
                                           std::span<const double> speeds);

/// The rows of a record: their speeds and the temperatures of the lubricant.
[[nodiscard]] model::Findings judge(const model::Model& model, const record::Record& record);

/// Throws text::InputError for a speed at which the ring bursts, or a temperature of the lubricant
/// at which it is solid: `name`, value with unit, possible range and the reason. NaN passes.
void require_possible_speed(const model::Model& model, double speed, const std::string& name);
void require_possible_temperature(const model::Model& model, double temperature,
                                  const std::string& name);
/// Checks all rows of a record, with file and line, also for water that enters the coolant channel
/// as ice or steam.
void require_possible(const model::Model& model, const record::Record& record);

}  // namespace raceway::session
