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

/// A requested Stribeck table.
struct TableQuestion {
  AskedAxes axes{};
  friction::TableSlab slab{};
  std::optional<model::Band> band{};  ///< with the half widths of its torque and loss
  Wording wording = Wording::arguments;
};

/// Grid and column names of a table, before it is computed.
struct TablePlan {
  friction::TableAxes axes;
  std::vector<std::string> columns;
};
/// Throws text::InputError as table_axes().
[[nodiscard]] TablePlan plan_table(Messages& messages, const files::ModelFile& file,
                                   const TableQuestion& question);

/// The table and its output formats.
struct TableAnswer {
  friction::StribeckTable table{};
  std::optional<model::Band> band{};
  model::Findings findings{};

  [[nodiscard]] std::string json(const model::Model& model) const;
  /// `format`: csv, with the model in its head, plain or modelica.
  [[nodiscard]] std::string text(const files::ModelFile& file, const std::string& format,
                                 const std::function<void(double)>& progress = {}) const;
  /// Notes for the user.
  [[nodiscard]] std::vector<std::string> notes(const model::Model& model) const;
  /// Limits that it passes.
  [[nodiscard]] std::vector<record::Note> warnings() const {
    return notes_of(record::note::over_limit, model::warnings_of(findings));
  }
};

/// Solves all points, on all cores. `progress` is called with the share that is done. Throws
/// fit::Cancelled where `cancelled` is set meanwhile.
[[nodiscard]] TableAnswer make_table(const files::ModelFile& file, const TableQuestion& question,
                                     TablePlan plan,
                                     const std::function<void(double)>& progress = {},
                                     const std::atomic<bool>* cancelled = nullptr);

/// Points that have no balance, and why, with the first of them; in lines for people. A torque
/// without balance is one, where the law needs no balls.
struct TableFailures {
  std::vector<std::string> lines{};
  bool without_torque = false;  ///< some points have no value at all
};
[[nodiscard]] TableFailures failures(const model::Model& model,
                                     const friction::StribeckTable& table);

/// Points whose balls a report draws: some speeds at some pairs of loads. None for a shaft, whose
/// bearings do not carry the loads of the grid.
[[nodiscard]] report::BearingStates states_to_draw(const model::Model& model,
                                                   const friction::TableAxes& grid);

}  // namespace raceway::session
