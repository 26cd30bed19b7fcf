#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "model/band.h"
#include "model/judgement.h"
#include "record/note.h"
#include "results/band_of_result.h"
#include "session/messages.h"
#include "session/wording.h"
#include "shaft/shaft_balance.h"
#include "shaft/shaft_prediction.h"

namespace raceway::session {

/// Request for the position of a shaft at several speeds. A load or temperature that is NaN is
/// replaced by the value of the model.
struct CurveQuestion {
  std::vector<double> speed_rpm{};
  double axial_load_N = unset, temperature_C = unset;
  /// Uncertainty band; if given, the results contain its half widths.
  std::optional<model::Band> band{};
  Wording wording = Wording::arguments;
};

/// Axial position of a shaft at several speeds. The model file must live longer than this object.
class ShaftCurve {
 public:
  /// Throws the same exceptions as operating_point(), and text::InputError for a model without a
  /// shaft and for more than a million speeds.
  ShaftCurve(Messages& messages, const files::ModelFile& file, const CurveQuestion& question);

  [[nodiscard]] const std::vector<shaft::ShaftPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<shaft::ShaftPrediction>& predictions() const {
    return predictions_;
  }
  /// Returns the bearing sets as mounted, at standstill.
  [[nodiscard]] bearing::Arrangement mounted() const {
    return shaft::mounted_arrangement(file_->model);
  }
  /// Returns the half widths of the uncertainty band; null if no band was requested.
  [[nodiscard]] const results::BandOfResult* band() const { return band_ ? &*band_ : nullptr; }
  /// Returns true if every speed has a position and a torque.
  [[nodiscard]] bool converged() const;
  /// Returns a warning or a note for each exceeded limit, with the speed at which the limit is
  /// exceeded most. Further warnings name bearings with too little load, and give the number of
  /// speeds without a result and the first of these speeds.
  [[nodiscard]] std::vector<record::Note> warnings() const;

  [[nodiscard]] std::string json() const;
  /// Returns the results as CSV, with one row for each speed.
  [[nodiscard]] std::string csv() const;
  /// Returns the results as one HTML page, with a kinematic law that is fitted to the shaft
  /// position.
  [[nodiscard]] std::string page() const;

 private:
  const files::ModelFile* file_;
  std::vector<shaft::ShaftPoint> points_;
  std::vector<shaft::ShaftPrediction> predictions_;
  std::optional<results::BandOfResult> band_;
  model::Findings findings_;
};

}  // namespace raceway::session
