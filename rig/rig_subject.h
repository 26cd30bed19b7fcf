#pragma once

#include "model/model_subject.h"

namespace raceway::rig {

/// Model of a bearing on a rig that measures friction torque or coasts down, as a fit::Subject.
class RigSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for the model of a shaft.
  explicit RigSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  /// Returns the equilibria for the values of the model file. Predictors that need an equilibrium
  /// use these equilibria as start values.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns the saturated regression, which has so many terms that its residuals are noise. Each
  /// term is the measured torque times a term of a cubic polynomial in ln speed, ln axial load and
  /// temperature. Radial load, preload and ring temperatures add quadratic terms if they vary. For
  /// cylindrical rollers, the radial load replaces the axial load.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  /// Returns the inputs with random errors: the temperature, if it varies in the record.
  [[nodiscard]] std::vector<const record::Channel*> scattering(
      const fit::Record& record) const override;
  /// Returns the quantities by whose powers an effect may be multiplied: speed, load and viscosity
  /// in each row. The load is the resultant of axial and radial load.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// Returns inputs and unit of the power law for a misfit that no effect explains. The power law
  /// gives the friction moment of one bearing and can become a user-defined effect.
  [[nodiscard]] std::optional<fit::Formula> formula(const fit::Record& record) const override;
  [[nodiscard]] std::vector<fit::Axis> axes(const fit::Record& record) const override;
  [[nodiscard]] std::string words(std::span<const fit::Setting> point) const override;
  /// Returns the laws that can replace the law of the model, with ids such as "law:skf".
  [[nodiscard]] std::vector<fit::OtherBase> other_bases() const override;
  /// Returns the data that the record lacks for a test of `id`, like ModelSubject::lacks(). Two
  /// parameters of the contact law have their own conditions: mu_boundary needs rows with a film
  /// ratio below 2, and limiting_traction needs rows with a contact pressure of 1.5 GPa or more.
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Returns measurements that would distinguish the rival explanations, such as a new measurement
  /// of the oil viscosity.
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
