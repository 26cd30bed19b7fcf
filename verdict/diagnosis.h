#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/hold_out.h"
#include "fit/likelihood.h"
#include "fit/noise_model.h"
#include "fit/refit.h"
#include "record/note.h"
#include "verdict/compare.h"

namespace raceway::verdict {

enum class Verdict {
  nothing_missing,  ///< the data show no missing effect, or the error is within the tolerance
  effect,           ///< one effect explains the misfit
  ambiguous,  ///< each of several effects explains the misfit, and the data cannot separate them
  several_effects,  ///< several effects are missing together
  effect_like,      ///< the misfit resembles an effect, but the data do not confirm this effect
  not_in_catalogue  ///< an effect is missing, and no candidate explains it
};

/// Returns the verdict as JSON results contain it, for example "nothing-missing".
[[nodiscard]] std::string_view name(Verdict verdict);

/// Diagnosis of one measured channel. Indices of readings in `noise`, such as `noise.outliers`, are
/// indices in `baseline.errors`.
struct ChannelDiagnosis {
  Comparison baseline{};  ///< comparison of the refitted model with the readings
  fit::NoiseModel noise{};
  /// RMS errors of the fits without and with the effects of the verdict [SI].
  double rmse_before = unset, rmse_after = unset;
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Held-out RMS errors without and with the effects of the verdict [SI]; NaN if no rows can be
  /// held out. If a tolerance is given, the blocks of rows with the lowest and the highest values
  /// of an input are not held out.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *baseline.channel; }
};

/// Fit of the model with one effect added. All free parameters of the model are refitted.
struct RankedEffect {
  std::string id;
  /// Name of the datum of the model that may be wrong, such as "the oil card" for the viscosities
  /// of the oil; empty for an effect.
  std::string datum{};
  std::string correction{};  ///< text with the corrected value of the datum
  /// Places where the effect acts (Candidate::acts_on). The id ends in ":" and the name of the
  /// place, unless the effect can act at one place only.
  std::vector<std::pair<std::string, std::string>> acts_on{};
  /// True if the id contains the record column on which the effect depends.
  bool by_column = false;
  bool in_verdict = false;
  /// Decrease of -2 ln L (L: likelihood) when the effect is added, minus a penalty [1]. The penalty
  /// is ln N for each parameter of the effect, with N readings. The size of the effect and
  /// parameters at a bound add no penalty. If the verdict is `several_effects` and includes this
  /// effect, `gain` is the gain of the whole set.
  double gain = unset;
  fit::Likelihood likelihood{};  ///< likelihood of the fit that gives `gain`
  std::vector<double> rmse{};    ///< RMS error of each channel on the rows of the fit [SI]
  /// Held-out RMS error of each channel [SI]; calculated only for the effects of the verdict and
  /// the six best other effects.
  std::vector<double> rmse_held_out{};
  /// Parameters of the effect; the names do not contain the id.
  std::vector<record::Parameter> parameters{};
  std::size_t size = 0;  ///< index in `parameters` of the size of the effect
  /// Free parameters of the model: `start` is the value fitted without the effect, `value` the
  /// value fitted with it. The difference shows how far these parameters had compensated for the
  /// missing effect.
  std::vector<record::Parameter> base{};
  /// Ids of the other candidates (effects or wrong data) that change these data in nearly the same
  /// way, or that stand in place of this candidate in another element of Diagnosis::sets.
  std::vector<std::string> indistinguishable_from{};
  /// P-value of the test for a further missing effect in addition to this one (verdict/gate.h); NaN
  /// if not tested.
  double remaining_p_value = unset;

  /// Returns the id without the place where the effect acts. If the id names a column
  /// (`by_column`), returns the whole id.
  [[nodiscard]] std::string plain_id() const {
    return acts_on.empty() || by_column ? id : id.substr(0, id.find(':'));
  }
};

/// Fit of a set of effects to the data.
struct SetFit {
  double gain = unset;  ///< gain of the whole set; see RankedEffect::gain
  fit::Likelihood likelihood{};
  std::vector<double> rmse{};  ///< RMS error of each channel on the rows of the fit [SI]
};

/// Correlation matrix of fitted parameters; NaN for a parameter at its bound.
struct Correlation {
  std::vector<std::string> names{};
  Eigen::MatrixXd matrix{};
};

/// Contribution of one effect to the readings [SI], channel by channel. Within a channel, the
/// readings are in the order of ChannelDiagnosis::baseline.errors.
struct EffectShare {
  std::string id;
  std::vector<double> readings{};
};

/// Readings that the model predicts with a set of effects, and the contribution of each effect. The
/// readings are sorted by channel, as in EffectShare.
struct ExplainedReadings {
  /// Prediction of the model with the effects and with refitted free parameters [SI].
  std::vector<double> total{};
  std::vector<double> base{};  ///< prediction of the same model with the effects switched off [SI]
  /// For each effect, `total` minus the prediction without this effect.
  std::vector<EffectShare> effects{};
};

/// Smallest size at which the diagnosis would have found an effect in 99 of 100 cases.
struct DetectableSize {
  std::string id;
  std::string parameter;
  std::string unit;
  double size = unset;  ///< smallest detectable value of `parameter`, in `unit`
  /// RMS of the contribution of the effect at this size, divided by the RMS of the readings; the
  /// largest ratio of all channels [1].
  double share_of_reading = unset;
  /// Id of the effect that is hardest to separate from this effect; empty if there is none.
  std::string most_alike{};
  /// Value of `parameter` above which the data separate the effect from `most_alike`; NaN if no
  /// allowed value is large enough.
  double told_apart_from = unset;
};

struct NotTestable {
  std::string id;
  /// Reason in words, for example missing data, or free parameters that change the readings in the
  /// same way as the effect.
  std::string reason;
};

/// Pattern over time of residuals that no effect of the catalogue explains.
struct Course {
  /// Start and end of each of the time spans with the largest residuals [s].
  std::vector<std::pair<double, double>> when{};
  double period = unset;         ///< period of the pattern [s]; NaN if the pattern does not repeat
  double time_constant = unset;  ///< correlation time of the residuals [s]
};

/// Measurement that would separate effects that the present data cannot separate.
struct SuggestedMeasurement {
  std::vector<fit::Setting> point;
  std::string words;  ///< description of the measuring point
  int repeats = 2;
  std::string separates{};  ///< ids of the two effects that the measurement would separate:
                            ///< "this-effect / that-effect"
  /// Difference between the readings that the two effects predict at this point, in standard
  /// deviations of the noise [1]. The effects are not refitted for this difference.
  double difference_in_sigma = unset;
};

/// Model in which another base law replaces the base law of the given model. Both models are
/// calibrated to the same readings.
struct OtherBaseTried {
  std::string id;     ///< id for add(), such as "law:skf"
  std::string words;  ///< name of the base law in model files
  /// Decrease of -2 ln L (L: likelihood) relative to the given model without effects, minus ln N
  /// for each additional free parameter, with N readings [1].
  double gain = unset;
  fit::Likelihood likelihood{};
  std::vector<double> rmse{};           ///< RMS error of each channel on the rows of the fit [SI]
  std::vector<double> rmse_held_out{};  ///< held-out RMS error of each channel [SI]
  std::vector<record::Parameter> parameters{};
  /// P-value of the test for a missing effect (verdict/gate.h) in this base model; NaN if not
  /// tested.
  double remaining_p_value = unset;
  bool explains = false;     ///< true if the data show no missing effect in this base model
  bool fitted_form = false;  ///< true if the exponents of this base law are also fitted
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing_missing;
  std::string headline;                    ///< verdict in one short line
  std::string sentence;                    ///< verdict with the numbers that support it
  std::vector<ChannelDiagnosis> channels;  ///< one for each channel of Subject::measured()
  /// P-value of the test for a missing effect (verdict/gate.h): probability of a misfit at least
  /// this large if no effect is missing.
  double p_value = unset;
  /// P-value of the test for a missing effect, after the effects of the verdict were added to the
  /// model.
  double remaining_p_value = unset;
  /// Effects of the verdict, best set first; then other effects by falling gain.
  std::vector<RankedEffect> effects;
  /// Sets of effects whose gain is close to the best gain, best first.
  std::vector<std::vector<std::string>> sets;
  /// One fit for each of `sets`; empty for a spindle model or a correction
  /// (Subject::approximates()).
  std::vector<SetFit> fits;
  /// Likelihood of the refitted model without effects, with the estimated noise.
  fit::Likelihood likelihood;
  /// Correlation of the parameters in the fit with the best set, or in the fit without effects if
  /// there is no set.
  Correlation correlation;
  /// Predicted readings, first with the best set of the verdict (if there is one), then with each
  /// of the other effects in `effects`.
  std::vector<ExplainedReadings> explained;
  bool verdict_is_explained = false;  ///< true if `explained` begins with the verdict's best set
  /// Refits of a spindle model or a correction (Subject::approximates()): first without effects,
  /// then with the best set of the verdict; empty for other models.
  std::vector<fit::Refit> refits;
  std::vector<DetectableSize> would_have_been_found;
  std::vector<NotTestable> not_testable;
  /// Groups of effects that change these readings in nearly the same way: the cosine between their
  /// changes is above 0.98 or below -0.98.
  std::vector<std::vector<std::string>> aliases;
  std::vector<SuggestedMeasurement> suggested_measurements;
  /// Inputs that can be set for a measurement, in the order of SuggestedMeasurement::point.
  std::vector<fit::Axis> axes;
  /// Predicted separation of the effects [1] by `suggested_measurements`, and by the same number of
  /// repeated readings: see NextPoints.
  double predicted_separation = unset, separation_by_repetition = unset;
  /// Quantities that would separate the effects if a new record contained them.
  std::vector<std::string> records_needed;
  std::optional<fit::Shape> shape;
  std::optional<Course> course;
  /// Free parameters of the model: `start` is the value fitted without the effects of the verdict,
  /// `value` the value fitted with them. Both are equal if the verdict names no effect.
  std::vector<record::Parameter> base;
  /// Held-out errors of the model with the best set of effects (the first element of `sets`),
  /// compared with the held-out errors without effects.
  std::vector<fit::HoldOut> hold_out;
  /// Gain that an effect needs: ln N + 2 ln m, with N readings and m candidates.
  double needed_gain = unset;
  int candidates_tried = 0;  ///< number m of candidates, including DiagnoseOptions::tried_before
  int rows = 0;              ///< number of rows used
  std::vector<std::size_t> outliers;            ///< rows with reduced weight
  std::vector<std::size_t> rows_not_predicted;  ///< rows without a prediction
  /// Other base models, best first; laws with fitted exponents come last. If `given_other_base` is
  /// not null, the first model of the list is the base model in `given_other_base`. Other base
  /// models are tried only if the verdict is `effect_like` or `not_in_catalogue`.
  std::vector<OtherBaseTried> other_bases{};
  /// Diagnosis with the first model of `other_bases` as the base model. This diagnosis tests only
  /// single effects, no pairs. Null if no other base model describes the readings clearly better
  /// than the given base model.
  std::shared_ptr<const Diagnosis> given_other_base{};
  /// True if a tolerance is given and the error of the refitted model without effects is within
  /// this tolerance. The compared error is the held-out error after subtraction of the noise:
  /// sqrt(error² - noise²). For a spindle model or a correction, the noise is not subtracted.
  bool within_tolerance = false;
  /// If `within_tolerance` is true: effects that are statistically significant and reduce the
  /// held-out error.
  std::vector<std::string> significant_but_immaterial;
  std::vector<record::Note> messages;  ///< messages for the user

  /// Returns true if a channel has a tolerance. The verdict then depends on the held-out error.
  [[nodiscard]] bool tolerance_limited() const;
};

}  // namespace raceway::verdict
