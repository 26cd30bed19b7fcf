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

/// Position of a shaft at several speeds. The object has a reference to the model file, which must
/// live longer than the object.
class ShaftCurve {
 public:
  ShaftCurve(const files::ModelFile& file, std::vector<shaft::ShaftPoint> points,
             const std::optional<model::Band>& band);

  [[nodiscard]] const std::vector<shaft::ShaftPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<shaft::ShaftPrediction>& predictions() const {
    return predictions_;
  }
  /// Returns the half widths of the uncertainty band; null if no band was requested.
  [[nodiscard]] const results::BandOfResult* band() const { return band_ ? &*band_ : nullptr; }
  /// Returns true if every speed has a position and a torque.
  [[nodiscard]] bool converged() const;
  /// Returns warnings of exceeded limits, each at the worst speed, of unloaded bearings, and of
  /// speeds without a value.
  [[nodiscard]] std::vector<record::Note> warnings() const;

  [[nodiscard]] std::string json() const;
  /// Returns the rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// Returns the report as one HTML page, with the fitted kinematic law.
  [[nodiscard]] std::string page() const;

 private:
  const files::ModelFile* file_;
  std::vector<shaft::ShaftPoint> points_;
  std::vector<shaft::ShaftPrediction> predictions_;
  std::optional<results::BandOfResult> band_;
  model::Findings findings_;
};

}  // namespace raceway::session
