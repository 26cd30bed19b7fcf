#pragma once

#include "model/model_subject.h"

namespace raceway::spindle {

/// Spindle model for fits to axial displacement and temperatures measured over time. Every channel
/// is weighted by its noise and by the expected accuracy of a spindle model.
class SpindleSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without a spindle.
  explicit SpindleSubject(const model::Model& model);

  /// Returns the displacement of the nose, then a temperature for each sensor, in the order of the
  /// model.
  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  /// Requires a time that rises within every run, a speed, and at least one measured channel.
  void require(const fit::Record& record) const override;
  [[nodiscard]] bool has_memory() const override { return true; }
  [[nodiscard]] bool approximates() const override { return true; }
  [[nodiscard]] bool is_costly() const override { return true; }
  /// Returns the time steps of the original model. Fits use the same steps.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  /// Simulates every run separately, starting from its ambient temperature. If the thermometers
  /// show that the first run of a record, or of a joined record, began warm (find_warm_start()),
  /// this run starts from the warm state. If the displacement was set to zero while the spindle was
  /// warm, the fit uses the zero that fits the readings best.
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Describes the runs of a record that start warm, one sentence each.
  [[nodiscard]] std::vector<std::string> warm_starts(const fit::Record& record) const;

  /// Returns the candidates without effects on the load or the condition of the turning bearings.
  /// A spindle has effects of its own for heat and friction.
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Returns eight consecutive parts with nearly equal numbers of rows; empty for a record with
  /// fewer than 16 rows.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  SpindleSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
};

}  // namespace raceway::spindle
