#pragma once

#include "model/model_subject.h"

namespace raceway::spindle {

/// Spindle model for fits to axial displacement and temperatures measured over time. The weight of
/// a measured channel comes from its noise and from the expected accuracy of a spindle model.
class SpindleSubject : public model::ModelSubject {
 public:
  /// Throws std::invalid_argument for a model without a spindle.
  explicit SpindleSubject(const model::Model& model);

  /// Returns the measured quantities: the axial displacement of the nose, then the temperature of
  /// each sensor in the order of the model.
  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  /// Throws std::invalid_argument if a row has no speed or no time, if the time does not increase
  /// within a run, or if the record has no channel that the model predicts.
  void require(const fit::Record& record) const override;
  [[nodiscard]] bool has_memory() const override { return true; }
  [[nodiscard]] bool approximates() const override { return true; }
  [[nodiscard]] bool is_costly() const override { return true; }
  /// Returns the runs of the record, and the time steps of a simulation with the values of the
  /// model file. Fits use these time steps for all parameter values. A simulation that fails with
  /// these time steps is repeated with its own step sizes.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  /// Returns a predictor that simulates every run on its own. A run starts at its ambient
  /// temperature, with one exception: if the thermometers show that the first run of a record, or
  /// of a part of a joined record, began warm (find_warm_start()), this run starts from the warm
  /// state. If the displacement was set to zero in this warm state, the mean error of the run is
  /// subtracted from the predicted displacement.
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns one sentence for each run that starts warm. The sentence describes the operation that
  /// find_warm_start() found before the run.
  [[nodiscard]] std::vector<std::string> warm_starts(const fit::Record& record) const;

  /// Returns the effects that a diagnosis may add. Effects on the load or the condition of the
  /// bearings in operation are left out, because they apply only to models without [shaft] and
  /// [housing].
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Returns the division of a record into eight consecutive parts with nearly equal numbers of
  /// rows, each of which is held out in turn. The result is empty for fewer than 16 rows.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  SpindleSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
};

}  // namespace raceway::spindle
