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

/// Request for the simulation of a spindle over a speed programme.
struct RunQuestion {
  Source programme;  ///< CSV with time_s, speed_rpm and further columns
  Reading reading{};
  /// File of initial temperatures; without this file, all parts start at ambient temperature.
  std::optional<Source> start{};
  /// Ambient temperature of every row [K]; NaN means the value of the programme, or the value of
  /// the model if the programme has none.
  double ambient_temperature = unset;
  bool coolant_on = true;    ///< false switches the coolant off in every row
  bool mesh = true;          ///< true adds an estimate of the mesh error to the result
  bool assumptions = false;  ///< true adds the most influential assumed values to the result
  const std::atomic<bool>* cancelled = nullptr;  ///< if true, the simulation throws fit::Cancelled
};

struct SpindleRun {
  files::ModelFile file;
  std::string programme{};  ///< name of the programme
  /// Rows of the programme. A simulation that ended early has one additional row at its end
  /// (spindle::add_end()).
  std::vector<spindle::ProfileRow> profile{};
  /// Initial state; if it is empty, all parts start at ambient temperature.
  std::optional<spindle::State> start{};
  spindle::Run run{};
  results::MeshEstimate mesh{};
  /// Most influential assumed values of the model, at the steady state of the highest speed.
  results::Assumptions assumptions{};
  std::vector<spindle::FieldCell> field{};  ///< temperature of each cell at the end of the run
  model::Findings findings{};

  [[nodiscard]] bool converged() const { return run.report.converged(); }
  /// Returns the number of rows of the programme, without the additional row of an early end.
  [[nodiscard]] std::size_t rows_asked() const { return profile.size() - (run.has_end ? 1 : 0); }
  [[nodiscard]] std::size_t rows_reached() const {
    return run.moments.size() - (run.has_end ? 1 : 0);
  }
  [[nodiscard]] std::vector<std::string> notes() const { return model::notes_of(findings); }
  /// If the simulation ended early, returns a warning with the time and the reason. Also returns a
  /// warning for each limit that the run exceeds.
  [[nodiscard]] std::vector<record::Note> warnings() const;
  [[nodiscard]] std::string json(bool with_assumptions = true) const;
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string page() const;
  [[nodiscard]] std::string end_state() const;
  [[nodiscard]] std::string field_csv() const;
};

/// Simulates a spindle. Throws text::InputError in these cases:
///   - The model is not a spindle.
///   - The programme has no time or no speed, or contains several runs.
///   - The programme begins before 0 s, and no initial state is given.
///   - The initial state does not belong to the spindle and mesh of the model.
[[nodiscard]] SpindleRun simulate_spindle(Messages& messages, const files::ModelFile& file,
                                          const RunQuestion& question);

}  // namespace raceway::session
