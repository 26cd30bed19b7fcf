#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "friction/stribeck_table.h"
#include "model/band.h"
#include "model/judgement.h"
#include "report/report.h"
#include "session/messages.h"
#include "session/operating_point.h"
#include "session/wording.h"

namespace raceway::session {

/// Request for a Stribeck table.
struct TableQuestion {
  AskedAxes axes{};
  friction::TableSlab slab{};
  /// If given, the table also contains the half widths of the 95 % bands of torque and power loss.
  std::optional<model::Band> band{};
  Wording wording = Wording::arguments;
};

/// Grid and column names of a table. They are known before the operating points of the grid are
/// solved.
struct TablePlan {
  friction::TableAxes axes;
  std::vector<std::string> columns;
};
/// Returns grid and column names. Throws the same exceptions as table_axes().
[[nodiscard]] TablePlan plan_table(Messages& messages, const files::ModelFile& file,
                                   const TableQuestion& question);

/// A computed table and its output formats.
struct TableAnswer {
  friction::StribeckTable table{};
  std::optional<model::Band> band{};
  model::Findings findings{};

  [[nodiscard]] std::string json(const model::Model& model) const;
  /// Returns the table as text. `format` is csv (with the model at the beginning), plain or
  /// modelica.
  [[nodiscard]] std::string text(const files::ModelFile& file, const std::string& format,
                                 const std::function<void(double)>& progress = {}) const;
  /// Returns the notes in `findings`, and a comparison of the torques with ceramic and with steel
  /// balls (balls_statement()). The operating point of the comparison has the highest speed, the
  /// first loads and the first temperature of the axes.
  [[nodiscard]] std::vector<std::string> notes(const model::Model& model) const;
  /// Returns warnings about exceeded limits.
  [[nodiscard]] std::vector<record::Note> warnings() const {
    return notes_of(record::note::over_limit, model::warnings_of(findings));
  }
};

/// Solves all operating points of the table on all processor cores. `progress` receives the
/// finished share, 0 to 1. Throws fit::Cancelled if `cancelled` is set during the calculation.
[[nodiscard]] TableAnswer make_table(const files::ModelFile& file, const TableQuestion& question,
                                     TablePlan plan,
                                     const std::function<void(double)>& progress = {},
                                     const std::atomic<bool>* cancelled = nullptr);

/// Lines of text about the operating points without a solution. Each line gives a reason, the
/// number of points with this reason, and the first of these points. If the friction law does not
/// need the ball loads, a point without equilibrium has a valid torque.
struct TableFailures {
  std::vector<std::string> lines{};
  bool without_torque = false;  ///< true if some points have no friction torque
};
[[nodiscard]] TableFailures failures(const model::Model& model,
                                     const friction::StribeckTable& table);

/// Returns solved points for the ball drawings of a report: at most 25 speeds at each of at most 12
/// pairs of axial and radial load, at the first temperature. Points without equilibrium are left
/// out. The result is empty for a shaft, because the loads of the grid are external loads, not
/// bearing loads.
[[nodiscard]] report::BearingStates states_to_draw(const model::Model& model,
                                                   const friction::TableAxes& grid);

}  // namespace raceway::session
