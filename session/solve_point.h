#pragma once

#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "friction/heat.h"
#include "model/prediction.h"

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

/// Of a point without balance, behind its numbers: that none exists where that is certain, and
/// otherwise that none was found.
[[nodiscard]] std::string words_of_absence(const bearing::SolveReport& report,
                                           const bearing::OperatingPoint& point);

[[nodiscard]] PointAnswer solve_point(const model::Model& model,
                                      const bearing::OperatingPoint& point);

/// What a user should know of an answer that has converged: loads above the rating, pressures that
/// leave dents, balls that may skid; and what makes it doubtful: a shoulder that cuts an ellipse.
[[nodiscard]] std::vector<std::string> notes_on_point(const model::Model& model,
                                                      const bearing::OperatingPoint& point,
                                                      const PointAnswer& answer);
[[nodiscard]] std::vector<std::string> warnings_on_point(const model::Model& model,
                                                         const PointAnswer& answer);

}  // namespace raceway::session
