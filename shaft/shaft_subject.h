#pragma once

#include "model/model_subject.h"

namespace raceway::shaft {

/// Shaft model as the fit::Subject of a measured axial displacement. For measured torque, see
/// SetTorqueSubject.
class ShaftSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit ShaftSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns the saturated regression of the base class. Each level of speed, axial load and
  /// preload is an additional term of the regression.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  /// Returns the quantities for tests of modified effect laws: speed, preload (0 if not recorded)
  /// and viscosity in each row.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// Returns a message if the readings are nearly proportional to the prediction, but with the
  /// opposite sign or with a factor above 200 or below 1/200; otherwise an empty text.
  [[nodiscard]] std::string doubt(const fit::Record& record,
                                  std::span<const double> predicted) const override;
  /// Returns inputs and levels for the next measurements. If the preload does not vary in the
  /// record, the levels include half and twice this preload.
  [[nodiscard]] std::vector<fit::Axis> axes(const fit::Record& record) const override;
  [[nodiscard]] std::string words(std::span<const fit::Setting> point) const override;
  /// Returns measurements that distinguish the rival explanations. Ring temperatures and runs with
  /// rising and falling speed separate effects of heat from effects of speed. The inspection sheet
  /// of the bearings is in the list if a bearing dimension is one of the explanations.
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
