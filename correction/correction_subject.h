#pragma once

#include <memory>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "correction/model.h"
#include "correction/numbers.h"
#include "fit/subject.h"

namespace raceway::correction {

/// Correction model of one displacement, in the form that calibrate(), diagnose() and add() fit.
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
  /// Returns the subject prepared for a fit to this record: with limits for the time constants, the
  /// list of input columns that vary, and the additional unknowns of the fit (see Beginning). The
  /// input ranges, covariance, residual and held-out error of an earlier fit are removed.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  /// Copies the input ranges of `model`, which informed_by() removes. Call this function to apply
  /// the fitted parameters of `model` to another record.
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
  /// Returns the full id, such as "second-time-constant:ambient", of the effect that the user
  /// named. The user may omit the channel or column after the colon if only one possible effect has
  /// this id. The full id omits the name of the first channel, but the user may write it. Unknown
  /// ids are returned unchanged. Throws std::invalid_argument if several effects match. Call this
  /// function on the result of informed_by().
  [[nodiscard]] std::string meant_by(const std::string& id) const;
  /// Returns the possible faults of the record: exchanged columns, a loose sensor, and a sensor
  /// with coarse resolution (see correction/effects/). Call this function on a fitted model.
  [[nodiscard]] std::vector<fit::Fault> faults(const fit::Record& record) const override;
  /// Returns the parts of the record that a test of the prediction holds out: eight consecutive
  /// parts with equal numbers of readings, or an empty list for fewer than 16 readings. If the
  /// record has several runs and an input varies mainly in one part, each run is split into eight
  /// parts instead. A part that contains nearly all variation of an input is never held out, nor is
  /// the first part if `initial_state` is "free".
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  /// Fitted unknown of the record that is not a parameter of the model: the zero of a later run or
  /// setup, or the initial state of a lag if `initial_state` is "free".
  struct Beginning {
    fit::Parameter parameter{};
    int zero = 0;  ///< index of the zero; unused for an initial state
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
  double end_ = 0.0;  // end of the record: 1 s after the last row [s]
  std::vector<Beginning> beginnings_{};
};

/// Returns the model of a CorrectionSubject. Throws std::invalid_argument if `subject` is not a
/// CorrectionSubject.
[[nodiscard]] const Model& model_of(const fit::Subject& subject);

}  // namespace raceway::correction
