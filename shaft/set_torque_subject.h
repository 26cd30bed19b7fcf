#pragma once

#include "shaft/shaft_subject.h"

namespace raceway::shaft {

/// The sets on a shaft whose friction torque is measured: the sum over all their bearings, each in
/// the balance of the sets.
class SetTorqueSubject final : public ShaftSubject {
 public:
  /// Throws std::invalid_argument for a model without shaft.
  explicit SetTorqueSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Of a torque, with the external load over the preload as the load.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  [[nodiscard]] std::vector<const record::Channel*> scattering(
      const fit::Record& record) const override;
  /// Speed, load (of preload and external load together) and viscosity.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// None: a torque has no sign to mistake, and files::doubts() looks at its unit.
  [[nodiscard]] std::string doubt(const fit::Record& record,
                                  std::span<const double> predicted) const override;
  /// The other laws.
  [[nodiscard]] std::vector<fit::OtherBase> other_bases() const override;
  /// Measurements that distinguish a wrong datum from an effect.
  [[nodiscard]] std::vector<std::string> records_needed(
      const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

 private:
  SetTorqueSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
  /// Those of the law: without loads of several sizes its factor of the load is hard to tell from
  /// the preload.
  [[nodiscard]] std::vector<std::string> usual_free() const override;
};

}  // namespace raceway::shaft
