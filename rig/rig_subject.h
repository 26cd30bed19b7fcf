#pragma once

#include "model/model_subject.h"

namespace raceway::rig {

/// Model that fits use for one bearing on a test rig (interface fit::Subject). The rig measures the
/// friction torque directly or by a coast-down.
class RigSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for the model of a shaft.
  explicit RigSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  /// Returns the ball equilibria of all rows, calculated with the parameter values of the model
  /// file (EnteredBalances). Predictors use these equilibria, or start from them if an effect
  /// changes the condition of the bearing.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns the saturated regression, which has so many terms that its residuals are noise. Each
  /// term is the predicted torque times a term of a cubic polynomial in ln speed, ln axial load and
  /// temperature. Radial load, preload and ring temperatures add quadratic terms if their values
  /// vary in the record. For cylindrical rollers, the radial load replaces the axial load.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  /// Returns the inputs whose readings have random errors. The only such input is the temperature,
  /// if the temperature varies in the record.
  [[nodiscard]] std::vector<const record::Channel*> scattering(
      const fit::Record& record) const override;
  /// Returns speed, load and viscosity in each row. The load is the resultant of axial and radial
  /// load. To test whether the formula of an effect depends correctly on one of these quantities,
  /// the program multiplies the formula by a power of this quantity.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// Returns inputs and unit of the power law that the program fits to the misfit if no effect
  /// explains the misfit. The power law gives the friction moment of one bearing. Users can add the
  /// power law to the model as a user-defined effect.
  [[nodiscard]] std::optional<fit::Formula> formula(const fit::Record& record) const override;
  [[nodiscard]] std::vector<fit::Axis> axes(const fit::Record& record) const override;
  [[nodiscard]] std::string words(std::span<const fit::Setting> point) const override;
  /// Returns the friction laws that can replace the law of the model, with ids such as "law:skf".
  [[nodiscard]] std::vector<fit::OtherBase> other_bases() const override;
  /// Returns a description of the data that are missing for a test of the effect or parameter `id`.
  /// The text is empty if no data are missing. For effects, the conditions are the same as in
  /// ModelSubject::lacks(). Two parameters of the contact law have their own conditions:
  /// mu_boundary needs rows with a film ratio below 2, and limiting_traction needs rows with a
  /// contact pressure of 1.5 GPa or more.
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Returns descriptions of measurements that would distinguish the rival explanations, such as a
  /// new measurement of the oil viscosity.
  [[nodiscard]] std::vector<std::string> records_needed(
      const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  RigSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
};

}  // namespace raceway::rig
