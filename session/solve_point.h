#pragma once

#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "friction/heat.h"
#include "model/judgement.h"
#include "model/prediction.h"
#include "record/note.h"
#include "results/band_of_result.h"

namespace raceway::session {

/// Results for one bearing at one operating point.
struct PointAnswer {
  bearing::SolveStatus status = bearing::SolveStatus::not_run;
  /// Friction results. All results are unset if the point has no equilibrium.
  model::FrictionPrediction friction{};
  /// Ball equilibrium with a report of the solver. The equilibrium of cylindrical rollers is in
  /// `friction`.
  bearing::BearingEquilibrium equilibrium{};
  friction::HeatSplit heat{};
  std::string why{};  ///< reason if the solve did not converge

  [[nodiscard]] bool converged() const { return status == bearing::SolveStatus::converged; }
};

/// Returns the reason for a point without equilibrium: either there is certainly no equilibrium, or
/// the solver did not find one.
[[nodiscard]] std::string words_of_absence(const bearing::SolveReport& report,
                                           const bearing::OperatingPoint& point);

[[nodiscard]] PointAnswer solve_point(const model::Model& model,
                                      const bearing::OperatingPoint& point);

/// Returns the JSON document of an answer; `band` may be null.
[[nodiscard]] std::string point_json(const model::Model& model,
                                     const bearing::OperatingPoint& point,
                                     const PointAnswer& answer, const results::BandOfResult* band);

/// Returns the limits that an answer exceeds; none without equilibrium.
[[nodiscard]] model::Findings judge(const model::Model& model, const bearing::OperatingPoint& point,
                                    const PointAnswer& answer);

/// Returns notes on a converged answer: the findings, and balls that may skid. Exceeded limits of
/// running bearings and contact ellipses that reach over the shoulder are warnings.
[[nodiscard]] std::vector<record::Note> notes_on_point(const model::Model& model,
                                                       const bearing::OperatingPoint& point,
                                                       const PointAnswer& answer);
[[nodiscard]] std::vector<record::Note> warnings_on_point(const model::Model& model,
                                                          const bearing::OperatingPoint& point,
                                                          const PointAnswer& answer);

}  // namespace raceway::session
