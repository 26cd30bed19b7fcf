#pragma once

#include "model/model_subject.h"

namespace raceway::spindle {

/// Spindle model for fits to axial displacement and temperatures measured over time. The weight of
/// a measured channel depends on its noise and on the error that is usual for spindle models.
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
  /// Prepares fits: simulates the runs of the record once with the values of the model file, and
  /// returns the runs and the time steps of these simulations. All simulations of a fit use these
  /// time steps. If a simulation with these time steps fails, it is repeated with automatic step
  /// sizes.
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  /// Returns a predictor that simulates each run separately. In general, a run starts at ambient
  /// temperature. The first run of a record starts warm if its thermometers show a warm start
  /// (find_warm_start()). If several records were joined, this rule applies to the first run of
  /// each record. If the displacement sensor was set to zero in the warm state, the function shifts
  /// the predicted displacement of the run, so that the mean of prediction minus reading is 0.
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;

  /// Returns one sentence for each run that starts warm. The sentence describes the estimated
  /// operation before the run.
  [[nodiscard]] std::vector<std::string> warm_starts(const fit::Record& record) const;

  /// Returns the effects that a diagnosis may add. Effects on the load or the condition of the
  /// bearings in operation are not in the list, because the spindle simulation computes load and
  /// condition itself. Such effects apply only to models of the bearing sets without [shaft] and
  /// [housing].
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// Divides a record into eight consecutive parts with nearly equal numbers of rows. The fit is
  /// repeated eight times, each time without the rows of one part. The result is empty for fewer
  /// than 16 rows.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  [[nodiscard]] model::Expected expected() const override;

 private:
  SpindleSubject(const model::Model& model, std::vector<std::string> waiting);
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model model,
                                                   std::vector<std::string> waiting) const override;
};

}  // namespace raceway::spindle
