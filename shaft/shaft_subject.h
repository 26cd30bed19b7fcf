#pragma once

#include "model/model_subject.h"

namespace raceway::shaft {

/// Shaft model that fits use to predict a measured axial displacement (interface fit::Subject).
/// SetTorqueSubject does the same for a measured torque.
class ShaftSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit ShaftSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns the saturated regression, which has so many terms that its residuals are noise
  /// (fit::Saturation). Each level of speed, axial load and preload adds a term to the regression
  /// of fit::Judged::saturation().
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  /// Returns speed, preload and viscosity in each row. To test whether the law of an effect depends
  /// correctly on one of these quantities, the program multiplies the law by a power of this
  /// quantity. A preload that is not recorded is 0 here.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// Returns a message if the readings are nearly proportional to the prediction, but have the
  /// opposite sign or differ by a factor above 200 or below 1/200. Otherwise, the text is empty.
  [[nodiscard]] std::string doubt(const fit::Record& record,
                                  std::span<const double> predicted) const override;
  /// Returns the inputs for the next measurements, each with the levels to measure. If the preload
  /// does not vary in the record, its levels are the present preload, half of it and twice as much.
  [[nodiscard]] std::vector<fit::Axis> axes(const fit::Record& record) const override;
  [[nodiscard]] std::string words(std::span<const fit::Setting> point) const override;
  /// Returns descriptions of measurements that would distinguish the rival explanations. For
  /// example, ring temperatures, or runs with rising and falling speed, distinguish effects of heat
  /// from effects of speed. The list includes the inspection sheet of the bearings if a bearing
  /// dimension is one of the explanations.
  [[nodiscard]] std::vector<std::string> records_needed(
      const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

  [[nodiscard]] model::Expected expected() const override;

 protected:
  ShaftSubject(const model::Model& model, std::vector<std::string> waiting);

 private:
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
  [[nodiscard]] std::vector<double> preload_levels(const fit::Record& record) const;
};

}  // namespace raceway::shaft
