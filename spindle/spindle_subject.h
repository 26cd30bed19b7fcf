#pragma once

#include "model/model_subject.h"

namespace raceway::spindle {

/// A spindle of which the axial displacement and temperatures are measured over time: all of them
/// together, each weighed by its noise and by how near such a model can come.
class SpindleSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without spindle.
  explicit SpindleSubject(const model::Model& model);

  /// The displacement of the nose, then a temperature for each sensor of the model, in its order.
  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  /// Time that rises within every run, speed, and at least one of what is measured.
  void require(const fit::Record& record) const override;
  [[nodiscard]] bool has_memory() const override { return true; }
  [[nodiscard]] bool approximates() const override { return true; }
  [[nodiscard]] bool is_costly() const override { return true; }
  /// The time steps of the model as it is, which fits keep to.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  /// Every run is simulated by itself, from the temperature of its room throughout; the first one
  /// from a past at speed where its thermometers say so (find_warm_start()). Where its displacement
  /// was set to zero warm, that zero is what fits the readings.
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// The runs of a record that start warm, a sentence each.
  [[nodiscard]] std::vector<std::string> warm_starts(const fit::Record& record) const;

  /// Without conditions of turning sets, which its own temperatures make.
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Eight parts, one after the other, with as many rows each.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  SpindleSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
};

}  // namespace raceway::spindle
