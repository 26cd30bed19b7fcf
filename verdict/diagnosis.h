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
  effect_like,      ///< the misfit resembles an effect, but with another law or an implausible size
  not_in_catalogue  ///< an effect is missing, and no candidate explains it
};

/// Returns the verdict in the words of the JSON results, for example "nothing-missing".
[[nodiscard]] std::string_view name(Verdict verdict);

/// Diagnosis of one measured channel. Indices of readings in `noise`, such as `noise.outliers`,
/// refer to the list `baseline.errors`.
struct ChannelDiagnosis {
  Comparison baseline{};  ///< comparison of the refitted model with the readings
  fit::NoiseModel noise{};
  /// RMS errors of the fits without and with the effects of the verdict [SI].
  double rmse_before = unset, rmse_after = unset;
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Held-out RMS errors without and with the effects of the verdict [SI]; NaN if no rows can be
  /// held out. If a tolerance is given, the blocks with the lowest and the highest values of an
  /// input are not held out.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *baseline.channel; }
};

/// Fit of the model with one effect added. All free parameters of the model are refitted.
struct RankedEffect {
  std::string id;
  /// Name of the datum that may be wrong ("the oil card": the viscosities of the oil); empty for an
  /// effect.
  std::string datum{};
  std::string correction{};  ///< text with the corrected value of the datum
  /// Places where the effect acts (Candidate::acts_on). The id ends in ":" and the name of the
  /// place, unless the effect can act at one place only.
  std::vector<std::pair<std::string, std::string>> acts_on{};
  bool by_column = false;  ///< true if the id names the column of the record that drives the effect
  bool in_verdict = false;
  /// Fall of -2 ln L when the effect is added, minus ln N for each parameter of the effect that is
  /// neither the size nor at a bound, with N readings. If the verdict is `several_effects` and
  /// includes this effect, this is the gain of the whole set.
  double gain = unset;
  fit::Likelihood likelihood{};  ///< likelihood of the fit that gives `gain`
  std::vector<double> rmse{};    ///< RMS error of each channel on the rows of the fit [SI]
  /// Held-out RMS error of each channel [SI]; calculated only for the effects of the verdict and
  /// the six best other effects.
  std::vector<double> rmse_held_out{};
  std::vector<record::Parameter> parameters{};  ///< parameters of the effect, named without its id
  std::size_t size = 0;  ///< index in `parameters` of the parameter that gives the size
  /// Free parameters of the model: `start` is the value fitted without the effect, `value` the
  /// value fitted with it. The difference shows how far these parameters had compensated for the
  /// missing effect.
  std::vector<record::Parameter> base{};
  /// Ids of the other candidates (effects or wrong data) that change these data in nearly the same
  /// way, or that replace this candidate in another set of the verdict.
  std::vector<std::string> indistinguishable_from{};
  /// p-value of the test for a further missing effect (verdict/gate.h); NaN if not tested
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
/// order of the readings is as in EffectShare.
struct ExplainedReadings {
  /// Prediction of the model with the effects and with refitted free parameters [SI].
  std::vector<double> total{};
  std::vector<double> base{};  ///< prediction of the same model with the effects switched off [SI]
  /// For each effect, `total` minus the prediction without this effect.
  std::vector<EffectShare> effects{};
};

/// Smallest size at which an effect would have been found in 99 of 100 cases.
struct DetectableSize {
  std::string id;
  std::string parameter;
  std::string unit;
  double size = unset;  ///< smallest detectable value of `parameter`, in `unit`
  /// RMS of the contribution of the effect at this size, divided by the RMS of the readings; the
  /// largest ratio of all channels [1].
  double share_of_reading = unset;
  std::string most_alike{};  ///< effect that is hardest to separate from this effect; may be empty
  /// Value of `parameter` above which the data separate the effect from `most_alike`; NaN if no
  /// allowed value is large enough.
  double told_apart_from = unset;
};

struct NotTestable {
  std::string id;
  /// Reason in words, for example missing data, or free parameters that change the readings in the
  /// same way.
  std::string reason;
};

/// Pattern of the residuals over time that no effect of the catalogue explains.
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
  std::string separates{};  ///< ids of the two effects: "this-effect / that-effect"
  /// Difference between the readings that the two effects predict at this point, in standard
  /// deviations of the noise [1]. The effects are not refitted for this difference.
  double difference_in_sigma = unset;
};

/// Another base model, calibrated to the same readings instead of the given base model.
struct OtherBaseTried {
  std::string id;     ///< id for add(), such as "law:skf"
  std::string words;  ///< name of the base law in model files
  /// Fall of -2 ln L relative to the given model without effects, minus ln N for each additional
  /// free parameter, with N readings.
  double gain = unset;
  fit::Likelihood likelihood{};
  std::vector<double> rmse{};           ///< RMS error of each channel on the rows of the fit [SI]
  std::vector<double> rmse_held_out{};  ///< held-out RMS error of each channel [SI]
  std::vector<record::Parameter> parameters{};
  /// P-value of the test for a missing effect (verdict/gate.h) in this base model; NaN if not
  /// tested.
  double remaining_p_value = unset;
  bool explains = false;     ///< true if the data show no missing effect in this base model
  bool fitted_form = false;  ///< true if the fit also finds exponents of this base law
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing_missing;
  std::string headline;                    ///< verdict in one short line
  std::string sentence;                    ///< verdict with the numbers that support it
  std::vector<ChannelDiagnosis> channels;  ///< channels, in the order of Subject::measured()
  /// P-value of the test for a missing effect (verdict/gate.h): probability of a misfit at least
  /// this large if no effect is missing.
  double p_value = unset;
  /// P-value of the same test with the effects of the verdict in the model.
  double remaining_p_value = unset;
  std::vector<RankedEffect>
      effects;  ///< effects of the verdict, best set first, then other effects, largest gain first
  std::vector<std::vector<std::string>>
      sets;  ///< sets of effects whose gain is close to the best, best first
  /// One fit for each of `sets`; empty if the model only approximates the readings.
  std::vector<SetFit> fits;
  /// Likelihood of the refitted model without effects, with the estimated noise.
  fit::Likelihood likelihood;
  /// Correlation of the parameters in the fit with the best set, or in the fit without effects if
  /// there is no set.
  Correlation correlation;
  /// Predicted readings with the best set of the verdict, if there is one, followed by the
  /// predicted readings with each ranked effect outside this set.
  std::vector<ExplainedReadings> explained;
  bool verdict_is_explained = false;  ///< true if `explained` begins with the verdict's best set
  /// Refits of a model that only approximates the readings: first without effects, then with the
  /// best set of the verdict.
  std::vector<fit::Refit> refits;
  std::vector<DetectableSize> would_have_been_found;
  std::vector<NotTestable> not_testable;
  /// Groups of effects that change these readings in nearly the same way: the cosine between their
  /// changes is above 0.98 or below -0.98.
  std::vector<std::vector<std::string>> aliases;
  std::vector<SuggestedMeasurement> suggested_measurements;
  /// Inputs that can be set for a measurement, in the order of SuggestedMeasurement::point.
  std::vector<fit::Axis> axes;
  double predicted_separation = unset, separation_by_repetition = unset;
  /// Further quantities to record that would separate the effects.
  std::vector<std::string> records_needed;
  std::optional<fit::Shape> shape;
  std::optional<Course> course;
  /// Free parameters of the model: `start` is the value fitted without the effects of the verdict,
  /// `value` the value fitted with them. Both are equal if the verdict names no effect.
  std::vector<record::Parameter> base;
  /// Held-out errors with the best set of the verdict, compared with the model without effects.
  std::vector<fit::HoldOut> hold_out;
  /// Gain that an effect needs: ln N + 2 ln m, with N readings and m candidates.
  double needed_gain = unset;
  int candidates_tried = 0;  ///< number m of candidates, including DiagnoseOptions::tried_before
  int rows = 0;              ///< number of rows used
  std::vector<std::size_t> outliers;            ///< rows with reduced weight
  std::vector<std::size_t> rows_not_predicted;  ///< rows without a prediction
  /// Other base models: first the model of `given_other_base`, if there is one. The others follow,
  /// best first, and laws with fitted exponents come last. Other base models are tried if no
  /// candidate explains the misfit, or if one candidate fits only with another law or an
  /// implausible size.
  std::vector<OtherBaseTried> other_bases{};
  /// Diagnosis with the first model of `other_bases` as the base model, with single candidates
  /// only. Null if no other base model is good enough.
  std::shared_ptr<const Diagnosis> given_other_base{};
  /// True if a tolerance is given and the held-out error of the refitted model without effects is
  /// within it after subtraction of the noise: sqrt(error² - noise²). `significant_but_immaterial`
  /// then names effects that are statistically significant and reduce the held-out error.
  bool within_tolerance = false;
  std::vector<std::string> significant_but_immaterial;
  std::vector<record::Note> messages;  ///< messages for the user

  /// Returns true if a channel has a tolerance. The verdict then depends on the held-out error.
  [[nodiscard]] bool tolerance_limited() const;
};

}  // namespace raceway::verdict
