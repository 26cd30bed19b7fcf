#pragma once

#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "friction/heat.h"
#include "model/judgement.h"
#include "model/prediction.h"
#include "record/note.h"

namespace raceway::session {

/// One bearing at one operating point, with all that is known of it there.
struct PointAnswer {
  bearing::SolveStatus status = bearing::SolveStatus::not_run;
  /// All unset where the point has no balance, as the rest.
  model::FrictionPrediction friction{};
  /// Its report says how the search ended. Cylindrical rollers in balance are in `friction`.
  bearing::BearingEquilibrium equilibrium{};
  friction::HeatSplit heat{};
  std::string why{};  ///< not converged, in words

  [[nodiscard]] bool converged() const { return status == bearing::SolveStatus::converged; }
};

/// Statement on a point without balance, for the end of its numbers: that none exists if that is
/// certain, otherwise that none was found.
[[nodiscard]] std::string words_of_absence(const bearing::SolveReport& report,
                                           const bearing::OperatingPoint& point);

[[nodiscard]] PointAnswer solve_point(const model::Model& model,
                                      const bearing::OperatingPoint& point);

/// Limits that an answer passes; none without balance.
[[nodiscard]] model::Findings judge(const model::Model& model, const bearing::OperatingPoint& point,
                                    const PointAnswer& answer);

/// Notes on a converged answer: its findings, balls that may skid. Warnings: limits of running
/// bearings, a shoulder that cuts an ellipse.
[[nodiscard]] std::vector<record::Note> notes_on_point(const model::Model& model,
                                                       const bearing::OperatingPoint& point,
                                                       const PointAnswer& answer);
[[nodiscard]] std::vector<record::Note> warnings_on_point(const model::Model& model,
                                                          const bearing::OperatingPoint& point,
                                                          const PointAnswer& answer);

}  // namespace raceway::session
