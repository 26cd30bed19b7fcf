#pragma once

#include "shaft/shaft_subject.h"

namespace raceway::shaft {

/// Shaft model that fits use to predict a measured friction torque (interface fit::Subject). The
/// torque is the sum over all bearings in the equilibrium of the sets.
class SetTorqueSubject final : public ShaftSubject {
 public:
  /// Throws std::invalid_argument for a model without a shaft.
  explicit SetTorqueSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns the saturated regression, which has so many terms that its residuals are noise
  /// (fit::Saturation). The load in this regression is the ratio of external load to preload.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  [[nodiscard]] std::vector<const record::Channel*> scattering(
      const fit::Record& record) const override;
  /// Returns speed, load and viscosity in each row. To test whether the formula of an effect
  /// depends correctly on one of these quantities, the program multiplies the formula by a power of
  /// this quantity. The load is sqrt(preload² + external load²).
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// Returns an empty text, because files::doubts() already checks the unit of the torque.
  [[nodiscard]] std::string doubt(const fit::Record& record,
                                  std::span<const double> predicted) const override;
  /// Returns the friction laws that can replace the law of the model.
  [[nodiscard]] std::vector<fit::OtherBase> other_bases() const override;
  /// Describes measurements that can distinguish between the explanations of the misfit in
  /// `rivals`.
  [[nodiscard]] std::vector<std::string> records_needed(
      const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

 private:
  SetTorqueSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
  /// Returns the default free parameters of the friction law, without the preload. If the record
  /// has only one load, a fit can hardly separate the preload from the load factor of the law.
  [[nodiscard]] std::vector<std::string> usual_free() const override;
};

}  // namespace raceway::shaft
