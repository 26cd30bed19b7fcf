#pragma once

#include <memory>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "correction/model.h"
#include "correction/numbers.h"
#include "fit/subject.h"

namespace raceway::correction {

/// Correction model of one displacement, as the input of calibrate(), diagnose() and add().
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
  /// Returns a copy that is prepared for a fit to this record. The copy contains limits for the
  /// time constants, the list of input columns that vary, and the additional unknowns of the fit
  /// (see Beginning). The results of an earlier fit are removed: input ranges, covariance, residual
  /// and held-out error.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  /// Copies the input ranges of `model` to this object. Call this function if a fitted model is
  /// applied to another record, because informed_by() removes the ranges.
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
  /// named. The user may omit the name of the channel or column after the colon if only one
  /// possible effect has the id before the colon. The full id of an effect on the first channel
  /// does not contain the name of this channel, but the user may add it. Unknown ids are returned
  /// unchanged. Throws std::invalid_argument if `id` fits several effects. Call this function on
  /// the result of informed_by().
  [[nodiscard]] std::string meant_by(const std::string& id) const;
  /// Returns the possible faults of the record: exchanged columns, a loose sensor, and a sensor
  /// with coarse resolution (see correction/effects/). Call this function on a fitted model.
  [[nodiscard]] std::vector<fit::Fault> faults(const fit::Record& record) const override;
  /// Returns a division of the record into parts. Each part is held out once to test the
  /// prediction. The parts are eight consecutive blocks with equal numbers of readings. If one part
  /// contains nearly all variation of an input and the record has several runs, each run is divided
  /// into eight blocks instead; part k then consists of block k of every run. A part that contains
  /// nearly all variation of an input is never held out. If `initial_state` is "free", the first
  /// part is never held out. The result is empty for fewer than 16 readings.
  [[nodiscard]] std::vector<fit::Blocking> blockings(const fit::Record& record) const override;

  /// Unknown that belongs to the record and is fitted together with the parameters of the model. It
  /// is the zero of the readings (constant offset) in a run or setup other than the first. If
  /// `initial_state` is "free", it may also be the initial state of a lag.
  struct Beginning {
    fit::Parameter parameter{};
    int zero = 0;  ///< value in Series::zero(); unused for an initial state
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
