#pragma once

#include <memory>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "correction/model.h"
#include "correction/numbers.h"
#include "fit/subject.h"

namespace raceway::correction {

/// Correction model of one displacement over time, for calibrate(), diagnose() and add().
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
  /// Returns the subject with the limits on time constants from the record, with the available
  /// columns, and with a zero for each run. The ranges, covariance and evidence of other records
  /// are removed, because the new parameters will come from this record.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  /// Takes the input range of `model`, which informed_by() removes. Use this function to apply the
  /// parameters of that model to another record.
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
  /// Returns the full id of the candidate that the user named, such as
  /// "second-time-constant:ambient". The user may omit the part after the colon if only one
  /// candidate has this effect id, and may name the first channel although its full id omits it.
  /// Unknown ids are returned unchanged. Throws std::invalid_argument if the name is ambiguous.
  /// Call this function on the result of informed_by().
  [[nodiscard]] std::string meant_by(const std::string& id) const;
  /// Returns the possible faults of the record: exchanged columns, a loose sensor, and a sensor
  /// with coarse resolution (see correction/effects/). Call this function on a fitted model.
  [[nodiscard]] std::vector<fit::Fault> faults(const fit::Record& record) const override;
  /// Returns eight consecutive parts of the record with equal numbers of readings; empty for fewer
  /// than 16 readings. If the record has several runs and an input varies mainly in one of these
  /// parts, each run is split into eight parts instead. A part that contains nearly all variation
  /// of an input is never held out. If the initial state is free, the first part is not held out
  /// either.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  /// Unknowns that are not parameters of the model [m]: the zero of each run or clamping after the
  /// first, and the initial states if `initial_state` is "free".
  struct Beginning {
    fit::Parameter parameter{};
    int zero = 0;  ///< index of the zero; a state has a channel and a section instead
    std::size_t channel = 0, section = 0;
    bool is_state = false;
  };

 private:
  [[nodiscard]] Effect as_switched_on(const std::string& id) const;
  [[nodiscard]] std::vector<Effect> possible() const;
  [[nodiscard]] Surroundings surroundings() const;

  Model model_;
  // Properties of the record passed to informed_by().
  bool informed_ = false;
  TimeConstantLimits limits_{};
  std::vector<const Channel*> columns_{};  // inputs that vary
  std::vector<Interval> ranges_{};         // range of each input
  std::vector<double> jump_times_{};
  double end_ = 0.0;  // end of the record, behind the last row [s]
  std::vector<Beginning> beginnings_{};
};

/// Returns the model of a correction subject. Throws std::invalid_argument for a subject of another
/// kind.
[[nodiscard]] const Model& model_of(const fit::Subject& subject);

}  // namespace raceway::correction
