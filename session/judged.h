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

/// Compares results with the limits in docs/limits.md, and rejects inputs outside the physical
/// range of a bearing.
namespace raceway::session {

/// Compares the contact pressure from the preload and the interferences in [seat] with the limits,
/// for a mounted shaft or spindle at standstill.
[[nodiscard]] model::Findings judge_mounted(const files::ModelFile& file);

/// Checks the interference of the inner rings of a spindle. Returns a note if the interference in
/// [seat] does not change the preload, because the preload is given as an offset or a class and the
/// model lacks the effect `interference-fit`. Returns a warning if [seat] and this effect give
/// different interferences.
[[nodiscard]] std::vector<record::Note> fit_notes(const model::Model& model);

/// Returns the findings whose `is_warning` is true, as warnings. Ignores all other findings.
[[nodiscard]] std::vector<record::Note> warnings_said(const model::Findings& findings);

/// Returns the findings whose `is_warning` is true as warnings, and all other findings as notes.
[[nodiscard]] std::vector<record::Note> said_of(const model::Findings& findings);

/// Compares the results for the bearing sets of a shaft with the limits.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const shaft::ShaftPoint> points,
                                    std::span<const shaft::ShaftPrediction> predictions);

/// Compares the results of a Stribeck table or of solve_states(), row by row, with the limits. For
/// roller bearings, only speed and lubricant temperature are compared.
class JudgedColumns {
 public:
  /// `names` contains the column names of the results. The model must live longer than this object.
  JudgedColumns(const model::Model& model, const std::vector<std::string>& names);
  void look(const bearing::OperatingPoint& point, std::span<const double> row,
            model::Judge& judge) const;

 private:
  struct OfBearing {
    std::string place;
    std::size_t lost = 0, inner = 0, outer = 0, load = 0, least = 0, largest = 0;
  };
  const model::Model* model_;
  std::vector<OfBearing> bearings_;
  std::size_t front_ = 0, rear_ = 0;
  double mounted_ = unset;
};

[[nodiscard]] model::Findings judge(const model::Model& model,
                                    const friction::StribeckTable& table);

/// Compares steady states of a spindle with the limits.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const results::SteadyState> states);

/// Compares the results of a spindle over a speed programme with the limits. The contact pressure
/// of each bearing is calculated at the time of the largest force on this bearing.
[[nodiscard]] model::Findings judge(const model::Model& model,
                                    std::span<const spindle::ProfileRow> profile,
                                    const spindle::Run& run);

/// Compares the bearing loads and the nose slope of a bent shaft with the limits. Throws
/// text::InputError if the nose slope is too large for beam theory.
[[nodiscard]] model::Findings judge(const model::Model& model, const bearing::Arrangement& mounted,
                                    const results::DeflectionResult& result, Wording wording);

/// Returns a note which says that the program uses the value at the edge of the friction table for
/// all operating points outside the table. Commands that do not count the points outside the table
/// print this note. The result is empty if the model has no friction table.
[[nodiscard]] std::vector<record::Note> states_not_counted(const model::Model& model);

/// Compares speeds [rad/s] with the limits of the bearings.
[[nodiscard]] model::Findings judge_speeds(const model::Model& model,
                                           std::span<const double> speeds);

/// Compares the speeds and lubricant temperatures in the rows of a record with the limits. For a
/// bearing on a rig, also counts the rows outside the range of the friction table.
[[nodiscard]] model::Findings judge(const model::Model& model, const record::Record& record);

/// Throws text::InputError for a speed at which an inner ring bursts, or for a temperature at which
/// the lubricant is solid. The message gives `name`, the value with its unit, the possible range
/// and the reason. NaN is allowed.
void require_possible_speed(const model::Model& model, double speed, const std::string& name);
void require_possible_temperature(const model::Model& model, double temperature,
                                  const std::string& name);
/// Throws text::InputError, with file and line, if a row of a record has an impossible speed or
/// temperature: see require_possible_speed(). For a water circuit, a recorded inlet temperature at
/// which water freezes or boils is also impossible.
void require_possible(const model::Model& model, const record::Record& record);

}  // namespace raceway::session
