#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "effects/effect.h"
#include "fit/compare.h"
#include "fit/data_set.h"
#include "fit/evidence.h"
#include "fit/hold_out.h"
#include "fit/interval.h"
#include "fit/model.h"
#include "fit/next_points.h"
#include "fit/noise_model.h"

namespace raceway::fit {

enum class Verdict {
  nothing_missing,  ///< nothing that these data can show
  effect,           ///< consistent with one effect
  ambiguous,        ///< one of several that the data cannot tell apart
  several_effects,  ///< two at once
  effect_like,      ///< acts like one, but by another law or of an implausible size
  not_in_catalogue  ///< something is missing, and no effect of the catalogue explains it
};

/// The verdict in the words of the JSON results, e.g. "nothing-missing".
[[nodiscard]] std::string_view name(Verdict verdict);

/// A fitted number of an effect, in the unit of the files.
struct EffectSize {
  std::string name;
  std::string unit;
  double value = unset;
  double std = unset;   ///< NaN at a bound
  Interval interval{};  ///< 95 %, by profile likelihood; of the size of an effect in the verdict
  double plausible_lower = unset, plausible_upper = unset;
  bool plausible = true;  ///< within the range met in practice, widened threefold
  bool at_bound = false;
};

/// A base parameter before and after an effect, or those of the verdict, was on.
struct BaseShift {
  std::string name;
  std::string unit;
  double before = unset, after = unset, std = unset;
};

/// How one effect explains the data, all base parameters refitted with it.
struct RankedEffect {
  std::string id;
  bool in_verdict = false;
  /// Fall of -2 ln L against the model without it, less ln N for each free shape; of the whole set
  /// where the verdict is `several_effects` and this effect is in it.
  double gain = unset;
  double rmse = unset;                  ///< [N m] or [m]
  double rmse_cross_validated = unset;  ///< over blocks that the fit did not see [N m] or [m]
  std::vector<EffectSize> parameters{};
  std::vector<BaseShift> base_shifts{};  ///< what the base parameters had been hiding of it
  std::vector<std::string> indistinguishable_from{};  ///< ids; names of base parameters
  double remaining_p_value = unset;  ///< of the gate with this effect on; NaN where not asked
};

/// Smallest size at which an effect would have been found in 99 of 100 cases.
struct DetectableSize {
  std::string id;
  std::string parameter;
  std::string unit;
  double size = unset;              ///< of that parameter
  double share_of_reading = unset;  ///< rms of the effect at that size over rms of the readings [1]
  std::string most_alike{};         ///< the effect it is hardest told from, empty if none
  double told_apart_from = unset;   ///< size from which it is told from that one
};

struct NotTestable {
  std::string id;
  std::string reason;  ///< what the data lack, or which parameters do the same
};

/// What is missing as a formula in the inputs, ready to be an effect of the user's own.
struct Shape {
  std::string formula;  ///< in the words of [[effect]] torque_Nmm
  std::vector<EffectSize> coefficients;
  std::string statement;           ///< where it is strongest, and its sign
  double explained_share = unset;  ///< of the squared misfit beyond the noise [1]
  double gain = unset;             ///< fall of -2 ln L against the model without it
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing_missing;
  std::string sentence;  ///< what a user reads first
  Comparison baseline;   ///< after refitting the free parameters
  NoiseModel noise;
  double p_value = unset;  ///< of the gate: chance of such a misfit if nothing were missing
  double remaining_p_value = unset;  ///< with the verdict's effects on
  std::vector<RankedEffect>
      effects;  ///< those of the verdict first, best set leading; then by rank
  std::vector<std::vector<std::string>>
      sets;  ///< explanations within reach of the best, best first
  std::vector<DetectableSize> would_have_been_found;
  std::vector<NotTestable> not_testable;
  std::vector<std::vector<std::string>> aliases;  ///< effects alike on these data (|cos| > 0.98)
  std::vector<SuggestedMeasurement> suggested_measurements;
  double predicted_separation = unset, separation_by_repetition = unset;
  std::vector<std::string> records_needed;  ///< what to record beside it, to tell them apart
  std::optional<Shape> shape;
  std::vector<BaseShift> base_shifts;              ///< what the base parameters had been hiding
  std::vector<HoldOut> hold_out;                   ///< of the verdict's best set against the base
  double rmse_before = unset, rmse_after = unset;  ///< in sample [N m] or [m]
  double needed_gain = unset;                      ///< ln N + 2 ln m
  int candidates_tried = 0;                        ///< m, with those tried before
  int rows = 0;                                    ///< used
  std::vector<int> outlier_lines;                  ///< counted with less weight
  std::vector<int> rows_not_predicted;
  std::vector<std::string> messages;  ///< what the user should know, one line each
};

struct DiagnoseOptions {
  /// What may be missing; the catalogue where empty.
  std::vector<const effects::Description*> candidates{};
  int tried_before = 0;  ///< other candidates once tried on these data, for the multiplicity
  int most_rows = most_rows_of_a_fit;
  bool pairs = true;
  NoiseOptions noise{};
  std::function<void(double share, std::string_view step)> progress{};
  const std::atomic<bool>* cancelled = nullptr;
};

/// Thrown when `cancelled` was set.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// Says whether an effect is missing in the model, which, or what to measure to find out. Effects
/// of the user's own whose size is zero are candidates beside those of the catalogue.
///
///   noise from a saturated regression -> gate (smooth misfit, largest score) -> each candidate
///   alone, then pairs, refitted with all base parameters -> gate again on what is left
///   -> blocked hold-out, plausible size -> next measurements
///
/// Level of the gate: 1 %. An effect is admitted where -2 ln L falls by more than ln N + 2 ln m,
/// and stands beside all others within 6 of the best.
/// Throws std::invalid_argument where the data cannot carry a verdict, and Cancelled.
[[nodiscard]] Diagnosis diagnose(const Model& model, const DataSet& data,
                                 const DiagnoseOptions& options = {});

}  // namespace raceway::fit
