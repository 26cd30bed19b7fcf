#pragma once

#include <string>
#include <string_view>

#include "correction/metrics.h"
#include "correction/model.h"
#include "correction/range.h"

/// Level of trust in a correction, derived from its error on held-out readings.
namespace raceway::correction {

enum class TrustLevel { unknown, do_not_use, within_range, good };

/// Returns "unknown", "do-not-use", "within-range" or "good".
[[nodiscard]] std::string_view name(TrustLevel level);

struct Trust {
  TrustLevel level = TrustLevel::unknown;
  std::string because{};  ///< reason in one clause; empty for `good`
};

/// Returns the line that the program prints: "good", "only inside its range: ...", "do not use,
/// because ..." or "not known: ...", with the reason.
[[nodiscard]] std::string line_of(const Trust& trust);

/// Returns the rms of the readings after subtracting the mean of each run [m]. The result is the
/// rms error without a correction.
[[nodiscard]] double uncorrected_rms(const Model& model, const record::Record& record);

/// Returns the Evidence for a model from the record to which it was fitted. `error` is the rms
/// error on held-out readings [m]; NaN if none were held out.
[[nodiscard]] Evidence evidence_on(const Model& model, const record::Record& record, double error);

/// Returns the level of trust for Model::evidence; `unknown` if the model has none. The conditions
/// are tested from top to bottom. The result is the first level in this table with a condition that
/// is met:
///
///   do not use    no readings were held out
///                 the readings only rise or only fall
///                 a time constant exceeds the duration of the readings
///                 the mean square of the error exceeds half of the mean square displacement
///   within range  a time constant exceeds a third of the duration of the readings
///                 the rms error exceeds the tolerance
///                 without a tolerance: the rms error exceeds a quarter of the rms displacement
///   good          otherwise
///
/// The error is Evidence::error, and the rms displacement is Evidence::uncorrected. If the error
/// comes from another record (`Evidence::other_record`), the conditions on the duration and on
/// readings that only rise or only fall are not checked.
/// Accuracy: the limits are our choice. Test: corrections were fitted to the first 1 to 12 h of the
///           data in data/corrections/exact, and applied to test.csv in this folder. If the level
///           was `good`, the rms error on test.csv was at most a fifth of the rms displacement.
[[nodiscard]] Trust trust_of(const Model& model);

/// Returns the level of trust in a prediction for a record. The level is `do_not_use` if the mean
/// square of the error exceeds half of the square of `uncorrected`, the rms displacement from
/// uncorrected_rms() [m]. Otherwise the level is the result of trust_of(). If this result is `good`
/// and a row is outside the input range of the fit, the level is `within_range`. `errors` are the
/// errors of the prediction, after a constant is subtracted for each run.
[[nodiscard]] Trust trust_on(const Model& model, const Metrics& errors, double uncorrected,
                             const Beyond& beyond);

}  // namespace raceway::correction
