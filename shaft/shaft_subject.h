#pragma once

#include "model/model_subject.h"

namespace raceway::shaft {

/// The sets on a shaft whose axial displacement is measured.
class ShaftSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without shaft.
  explicit ShaftSubject(const model::Model& model);

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// The polynomial of the base class: what may be missing adds to a displacement.
  [[nodiscard]] fit::Saturation saturation(const fit::Record& record) const override;
  /// Speed, preload and viscosity.
  [[nodiscard]] std::vector<fit::Factor> factors(const fit::Record& record) const override;
  /// A displacement a thousand times too small or large, or of the other sign.
  [[nodiscard]] std::string doubt(const fit::Record& record,
                                  std::span<const double> predicted) const override;
  /// Axes of a plan, among them the preload, also at other values than in the record.
  [[nodiscard]] std::vector<fit::Axis> axes(const fit::Record& record) const override;
  [[nodiscard]] std::string words(std::span<const fit::Setting> point) const override;
  /// Ring temperatures, and runs up and down, where heat and speed are rivals.
  [[nodiscard]] std::vector<std::string> records_needed(
      const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  ShaftSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
  [[nodiscard]] std::vector<double> preload_levels(const fit::Record& record) const;
};

}  // namespace raceway::shaft
