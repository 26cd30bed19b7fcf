#pragma once

#include <memory>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "correction/model.h"
#include "correction/numbers.h"
#include "fit/subject.h"

namespace raceway::correction {

/// A correction model as the loop sees it: one displacement over time.
class CorrectionSubject : public fit::Subject {
 public:
  explicit CorrectionSubject(Model model);

  [[nodiscard]] const Model& model() const { return model_; }

  [[nodiscard]] std::vector<fit::Measured> measured() const override;
  void require(const fit::Record& record) const override;
  [[nodiscard]] bool has_memory() const override { return true; }
  [[nodiscard]] bool approximates() const override { return true; }
  [[nodiscard]] std::shared_ptr<const void> prepare(const fit::Record& record) const override;
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const fit::Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;
  /// The subject with the time constants that the record can show, the columns that it has, and a
  /// zero for each of its runs. Parameters found from a record have seen all of it, so the ranges,
  /// covariance and evidence of other records are dropped.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  /// The range of a model, where its numbers are compared with another record.
  void keep_range(const Model& model);

  [[nodiscard]] std::vector<fit::Parameter> parameters() const override;
  [[nodiscard]] std::vector<std::string> free() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_values(
      std::span<const fit::NamedValue> values) const override;

  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_candidates(
      std::span<const std::string> ids) const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  /// The candidate that a person means: "second-time-constant:ambient", or without what it acts on
  /// where that is the main channel or the only axis. Unknown ids are returned unchanged. Throws
  /// std::invalid_argument where several are meant. Call it on a subject that a record informed.
  [[nodiscard]] std::string meant_by(const std::string& id) const;
  /// Sensors whose resolution shows: the displacement steps with the last digit, and the residual
  /// steps back by no more than this effect explains. For a fitted model.
  [[nodiscard]] std::vector<fit::Fault> faults(const fit::Record& record) const override;
  /// Eight parts of the record, one after the other, with as many readings each; eight of every run
  /// where an input moves within one part alone. Parts that still hold nearly all of what an input
  /// does are in none, nor is the first of a record that began warm.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  /// Unknowns that are no numbers of the model: the zero of each run after the first, and the
  /// initial states of a record that did not begin at rest [m].
  struct Beginning {
    fit::Parameter parameter{};
    int zero = 0;  ///< of which run, or
    std::size_t channel = 0, section = 0;
    bool is_state = false;
  };

 private:
  [[nodiscard]] Effect as_switched_on(const std::string& id) const;
  [[nodiscard]] std::vector<Effect> possible() const;
  [[nodiscard]] Surroundings surroundings() const;

  Model model_;
  // Properties of the record that informed it.
  bool informed_ = false;
  TimeConstantLimits limits_{};
  std::vector<const Channel*> columns_{};  // inputs that vary
  std::vector<Interval> ranges_{};         // and how far
  std::vector<double> jump_times_{};
  double end_ = 0.0;  // behind the last row [s]
  std::vector<Beginning> beginnings_{};
};

/// The model of a subject. Throws std::invalid_argument for one of another kind.
[[nodiscard]] const Model& model_of(const fit::Subject& subject);

}  // namespace raceway::correction
