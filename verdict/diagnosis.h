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
  nothing_missing,  ///< nothing that these data can show, or that matters
  effect,           ///< consistent with one effect
  ambiguous,        ///< one of several that the data cannot tell apart
  several_effects,  ///< two at once
  effect_like,      ///< acts like one, but by another law or of an implausible size
  not_in_catalogue  ///< something is missing, and no candidate explains it
};

/// The verdict in the words of the JSON results, e.g. "nothing-missing".
[[nodiscard]] std::string_view name(Verdict verdict);

/// Diagnosis of one measured channel, readings in the order of `baseline.errors`.
struct ChannelDiagnosis {
  Comparison baseline{};  ///< after refitting the free parameters
  fit::NoiseModel noise{};
  double rmse_before = unset, rmse_after = unset;  ///< in sample [SI]
  double tolerance = unset;                        ///< SI; NaN if not given
  /// Held-out errors without and with the verdict [SI]; with a tolerance, within the measured
  /// range.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *baseline.channel; }
};

/// Fit of one effect to the data, all base parameters refitted with it.
struct RankedEffect {
  std::string id;
  std::string datum{};       ///< Candidate::datum: what is wrong, rather than missing
  std::string correction{};  ///< corrected value of that datum, in words
  /// Candidate::acts_on; the id then ends in ":" and its name, unless there is only one.
  std::vector<std::pair<std::string, std::string>> acts_on{};
  bool by_column = false;  ///< Candidate::by_column
  bool in_verdict = false;
  /// Fall of -2 ln L against the model without it, less ln N for each free shape; of the whole set
  /// where the verdict is `several_effects` and this effect is in it.
  double gain = unset;
  fit::Likelihood likelihood{};                 ///< of what the gain is of
  std::vector<double> rmse{};                   ///< of each channel [SI]
  std::vector<double> rmse_held_out{};          ///< held-out error of each channel [SI]
  std::vector<record::Parameter> parameters{};  ///< named without the id
  std::size_t size = 0;                         ///< index of the one that gives it its size
  /// Base parameters without it (start) and with it (value): what they had been hiding of it.
  std::vector<record::Parameter> base{};
  std::vector<std::string> indistinguishable_from{};  ///< ids; names of base parameters
  double remaining_p_value = unset;  ///< of the gate with this effect on; NaN where not asked

  /// The id of its kind, wherever it acts; with its column where that is all that is known of it.
  [[nodiscard]] std::string plain_id() const {
    return acts_on.empty() || by_column ? id : id.substr(0, id.find(':'));
  }
};

/// Fit of a set of effects to the data.
struct SetFit {
  double gain = unset;  ///< RankedEffect::gain, of the whole set
  fit::Likelihood likelihood{};
  std::vector<double> rmse{};  ///< of each channel [SI]
};

/// Correlation of estimates; NaN at a bound.
struct Correlation {
  std::vector<std::string> names{};
  Eigen::MatrixXd matrix{};
};

/// Contribution of one effect to the readings [SI], in the order of the channels and of their
/// `baseline.errors`.
struct EffectShare {
  std::string id;
  std::vector<double> readings{};
};

/// Readings that a set of effects predicts, and their parts, ordered as above.
struct ExplainedReadings {
  std::vector<double> total{};         ///< effects on, base parameters refitted with them [SI]
  std::vector<double> base{};          ///< with the effects off again [SI]
  std::vector<EffectShare> effects{};  ///< the total less that without this one effect
};

/// Smallest size at which an effect would have been found in 99 of 100 cases.
struct DetectableSize {
  std::string id;
  std::string parameter;
  std::string unit;
  double size = unset;              ///< of that parameter
  double share_of_reading = unset;  ///< rms of the effect at that size over rms of the readings [1]
  std::string most_alike{};         ///< the effect it is hardest told from, empty if none
  double told_apart_from = unset;   ///< size from which the two are separated
};

struct NotTestable {
  std::string id;
  std::string reason;  ///< missing data, parameters that act alike, or a reason that rules it out
};

/// Residuals over time that no effect of the catalogue explains.
struct Course {
  std::vector<std::pair<double, double>> when{};  ///< from and to, where it is largest [s]
  double period = unset;         ///< after which it comes back [s]; NaN where it does not
  double time_constant = unset;  ///< correlation time [s]
};

/// Measurement that would separate effects that the data cannot.
struct SuggestedMeasurement {
  std::vector<fit::Setting> point;
  std::string words;  ///< of the point
  int repeats = 2;
  std::string separates{};             ///< ids, e.g. "this-effect / that-effect"
  double difference_in_sigma = unset;  ///< of that pair at this point, before any refit [1]
};

/// Another base model in the place of the given one, calibrated to the same readings.
struct OtherBaseTried {
  std::string id;     ///< OtherBase::id
  std::string words;  ///< OtherBase::words
  /// Fall of -2 ln L against the given model without effects, less ln N for each further number
  /// that is free.
  double gain = unset;
  fit::Likelihood likelihood{};
  std::vector<double> rmse{};           ///< of each channel [SI]
  std::vector<double> rmse_held_out{};  ///< held-out error of each channel [SI]
  std::vector<record::Parameter> parameters{};
  double remaining_p_value = unset;  ///< of the gate on its residuals; NaN where not asked
  bool explains = false;             ///< nothing is missing in it that these data can show
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing_missing;
  std::string headline;                    ///< for a person, without its proof
  std::string sentence;                    ///< the verdict with the numbers it rests on
  std::vector<ChannelDiagnosis> channels;  ///< measured ones, the first leading
  double p_value = unset;  ///< of the gate: chance of such a misfit if nothing were missing
  double remaining_p_value = unset;  ///< with the verdict's effects on
  std::vector<RankedEffect>
      effects;  ///< effects of the verdict first, best set leading; then by rank
  std::vector<std::vector<std::string>>
      sets;                    ///< explanations within reach of the best, best first
  std::vector<SetFit> fits;    ///< of these sets; empty of a subject that only approximates
  fit::Likelihood likelihood;  ///< of the refitted model without effects, under the noise found
  Correlation correlation;     ///< of the parameters of the best set, or of the model without one
  /// The verdict's best set first, where there is one; then every single effect that is ranked.
  std::vector<ExplainedReadings> explained;
  bool verdict_is_explained = false;  ///< `explained` begins with the verdict's best set
  /// Refits of a subject that only approximates: itself, then with the verdict's best set.
  std::vector<fit::Refit> refits;
  std::vector<DetectableSize> would_have_been_found;
  std::vector<NotTestable> not_testable;
  std::vector<std::vector<std::string>> aliases;  ///< effects alike on these data (|cos| > 0.98)
  std::vector<SuggestedMeasurement> suggested_measurements;
  std::vector<fit::Axis> axes;  ///< at which one may measure, in the order of a suggested point
  double predicted_separation = unset, separation_by_repetition = unset;
  std::vector<std::string> records_needed;  ///< further quantities to record, to separate them
  std::optional<fit::Shape> shape;
  std::optional<Course> course;
  /// Base parameters without (start) and with the verdict (value), which are the same where it
  /// names nothing.
  std::vector<record::Parameter> base;
  std::vector<fit::HoldOut> hold_out;           ///< of the verdict's best set against the base
  double needed_gain = unset;                   ///< ln N + 2 ln m
  int candidates_tried = 0;                     ///< m, with those tried before
  int rows = 0;                                 ///< used
  std::vector<std::size_t> outliers;            ///< rows counted with less weight
  std::vector<std::size_t> rows_not_predicted;  ///< rows
  /// Tried where no candidate explains the misfit, the best first.
  std::vector<OtherBaseTried> other_bases{};
  /// Diagnosis with the first of them as the base model, single candidates only; null if none is
  /// worth it.
  std::shared_ptr<const Diagnosis> given_other_base{};
  /// With a tolerance: true if the refitted model is good enough without effects; and effects that
  /// are certain and lower the held-out error, but do not matter.
  bool within_tolerance = false;
  std::vector<std::string> significant_but_immaterial;
  std::vector<record::Note> messages;  ///< for the user

  /// A tolerance was given, and decides.
  [[nodiscard]] bool tolerance_limited() const;
};

}  // namespace raceway::verdict
