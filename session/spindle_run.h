#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "record/note.h"
#include "results/spindle_results.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// A spindle through a speed programme.
struct RunQuestion {
  Source programme;  ///< CSV with time_s, speed_rpm and what else is known
  Reading reading{};
  std::optional<Source> start{};       ///< temperatures to begin with; none: all as the room
  double ambient_temperature = unset;  ///< in every row [K]; NaN: its column, else the model
  bool coolant_on = true;              ///< false: off in every row
  bool mesh = true;                    ///< whether the estimate of the cells is wanted
  bool assumptions = false;            ///< whether those that matter most are wanted
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

struct SpindleRun {
  files::ModelFile file;
  std::string programme{};  ///< its name
  /// Rows of the programme. A run that ended early has a row more, at its end: spindle::add_end().
  std::vector<spindle::ProfileRow> profile{};
  std::optional<spindle::State> start{};
  spindle::Run run{};
  results::MeshEstimate mesh{};
  results::Assumptions assumptions{};       ///< at the steady state of the highest speed
  std::vector<spindle::FieldCell> field{};  ///< at the end
  model::Findings findings{};

  [[nodiscard]] bool converged() const { return run.report.converged(); }
  /// Rows of the programme, without an early end that stands behind them.
  [[nodiscard]] std::size_t rows_asked() const { return profile.size() - (run.has_end ? 1 : 0); }
  [[nodiscard]] std::size_t rows_reached() const {
    return run.moments.size() - (run.has_end ? 1 : 0);
  }
  [[nodiscard]] std::vector<std::string> notes() const { return model::notes_of(findings); }
  /// Place and reason of an early end, and limits that it passes.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json(bool with_assumptions = true) const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
  [[nodiscard]] std::string end_state() const;
  [[nodiscard]] std::string field_csv() const;
};

/// Throws text::InputError for a model that is no spindle, a programme without time or speed, one
/// of several runs or one that begins before 0 s, and a state of another spindle.
[[nodiscard]] SpindleRun simulate_spindle(Messages& messages, const files::ModelFile& file,
                                          const RunQuestion& question);

}  // namespace raceway::session
