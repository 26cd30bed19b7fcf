#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "friction/heat.h"
#include "model/band.h"
#include "model/judgement.h"
#include "model/prediction.h"
#include "record/note.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

namespace raceway::session {

/// Results at one operating point, for one bearing or for the bearing sets on a shaft.
struct PointAnswer {
  bearing::SolveStatus status = bearing::SolveStatus::not_run;
  /// Friction results of one bearing. If the point has not converged, all results are NaN.
  model::FrictionPrediction friction{};
  /// Ball equilibrium with a report of the solver. The equilibrium of cylindrical rollers is in
  /// `friction`.
  bearing::BearingEquilibrium equilibrium{};
  friction::HeatSplit heat{};  ///< friction heat of the inner and of the outer ring [W]
  /// Results of a shaft. `friction`, `equilibrium` and `heat` are not used for a shaft.
  std::optional<shaft::ShaftPrediction> shaft{};
  /// Half widths of the 95 % confidence band, if the caller requests it.
  std::optional<results::BandOfResult> band{};
  model::Findings findings{};  ///< limits that the results exceed
  /// Operating point and the reason why it has not converged. Valid only if converged() is false.
  std::string why{};

  [[nodiscard]] bool converged() const { return status == bearing::SolveStatus::converged; }
};

/// Solves one operating point. On a shaft, the axial load of the point is the external load.
[[nodiscard]] PointAnswer solve_point(const model::Model& model,
                                      const bearing::OperatingPoint& point,
                                      const std::optional<model::Band>& band = {});

/// Returns the results as a JSON document.
[[nodiscard]] std::string point_json(const model::Model& model,
                                     const bearing::OperatingPoint& point,
                                     const PointAnswer& answer);

/// Returns notes on exceeded limits, and on loads and contacts of the bearings, at one operating
/// point. Three kinds of note are warnings: a finding with `is_warning`, a bearing of a shaft with
/// too little load, and a contact ellipse that extends over a shoulder.
[[nodiscard]] std::vector<record::Note> notes_on_point(const model::Model& model,
                                                       const bearing::OperatingPoint& point,
                                                       const PointAnswer& answer);

}  // namespace raceway::session
