#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "model/band.h"
#include "model/judgement.h"
#include "record/note.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

namespace raceway::session {

/// The position of a shaft at several speeds. It refers to the file of its model.
class ShaftCurve {
 public:
  ShaftCurve(const files::ModelFile& file, std::vector<shaft::ShaftPoint> points,
             const std::optional<model::Band>& band);

  [[nodiscard]] const std::vector<shaft::ShaftPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<shaft::ShaftPrediction>& predictions() const {
    return predictions_;
  }
  /// Half widths of the band; null where none was asked for.
  [[nodiscard]] const results::BandOfResult* band() const { return band_ ? &*band_ : nullptr; }
  /// Returns true if every speed has a position and a torque.
  [[nodiscard]] bool converged() const;
  /// Limits that are passed at the worst speed, unloaded bearings, and speeds without a value.
  [[nodiscard]] std::vector<record::Note> warnings() const;

  [[nodiscard]] std::string json() const;
  /// The rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// The report, as one page, with the kinematic law of the curve.
  [[nodiscard]] std::string page() const;

 private:
  const files::ModelFile* file_;
  std::vector<shaft::ShaftPoint> points_;
  std::vector<shaft::ShaftPrediction> predictions_;
  std::optional<results::BandOfResult> band_;
  model::Findings findings_;
};

}  // namespace raceway::session
