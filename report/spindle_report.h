#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/report.h"
#include "results/spindle_results.h"
#include "spindle/drawn_run.h"

/// Writes the HTML pages of `raceway spindle`. A page shows a run over time or steady states over
/// speed, and the cross-section of the spindle with the temperature of each cell.
namespace raceway::report {

/// Temperatures of all cells of the mesh at one time, or in the steady state at one speed.
struct DrawnField {
  double time = unset;   ///< [s]; NaN for a steady state
  double speed = unset;  ///< [rad/s]
  std::vector<spindle::FieldCell> cells;
};

/// Returns the page of a run. `programme` names the speed programme, and `rows_asked` is the number
/// of rows of the speed programme. `mesh_text` is a sentence on the discretisation error.
[[nodiscard]] std::string spindle_run_report(
    const ModelOfPage& model, const std::string& programme, std::size_t rows_asked,
    const spindle::Run& run, const spindle::DrawnRun& drawn, std::span<const DrawnField> fields,
    const results::MeshEstimate& mesh, const std::string& mesh_text,
    const model::Findings& findings = {}, const results::Assumptions& assumptions = {});

[[nodiscard]] std::string spindle_steady_report(const ModelOfPage& model,
                                                std::span<const results::SteadyState> states,
                                                std::span<const DrawnField> fields,
                                                const results::MeshEstimate& mesh,
                                                const std::string& mesh_text,
                                                const model::Findings& findings = {},
                                                const results::Assumptions& assumptions = {});

}  // namespace raceway::report
