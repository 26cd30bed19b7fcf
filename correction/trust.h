#pragma once

#include <string>
#include <string_view>

#include "correction/metrics.h"
#include "correction/model.h"
#include "correction/range.h"

/// Rates how far a correction can be trusted, from its error on held-out readings.
namespace raceway::correction {

enum class TrustLevel { unknown, do_not_use, within_range, good };

/// Returns "unknown", "do-not-use", "within-range" or "good".
[[nodiscard]] std::string_view name(TrustLevel level);

struct Trust {
  TrustLevel level = TrustLevel::unknown;
  std::string because{};  ///< reason in one clause; empty for good
};

/// Returns one line for the reader: "good", "only inside its range: ...", "do not use, because
/// ...", "not known: ...".
[[nodiscard]] std::string line_of(const Trust& trust);

/// Returns the rms of the readings after subtracting the mean of each run [m]. This rms is the
/// error without a correction.
[[nodiscard]] double uncorrected_rms(const Model& model, const record::Record& record);

/// Returns the evidence from the record to which a model was fitted. `error` is the rms error on
/// held-out readings [m]; NaN if nothing could be held out.
[[nodiscard]] Evidence evidence_on(const Model& model, const record::Record& record, double error);

/// Returns the trust that the evidence of a model supports; `unknown` if the model has no evidence.
/// The first matching level is used:
///
///   do not use    nothing was held out; the readings move only once from one state to another; a
///                 time constant is longer than the readings; the residual contains more than half
///                 of the mean square of the displacement
///   within range  a time constant is longer than a third of the readings; the error exceeds the
///                 tolerance or, without a tolerance, a quarter of the displacement
///   good          otherwise
///
/// If the error comes from another record (`Evidence::other_record`), the conditions on the length
/// of the readings and on readings that move only once are not checked.
/// Accuracy: the limits are our choice. The limits were tested on corrections found in the first 1
/// to 12 h of data/corrections/exact. No correction whose residual in test.csv exceeds a fifth of
/// the displacement is rated good.
[[nodiscard]] Trust trust_of(const Model& model);

/// Returns the trust for a record. The level is `do_not_use` if the error leaves more than half of
/// the mean square of the displacement in this record; otherwise trust_of() applies. If the record
/// leaves the range of the fit, `good` becomes `within_range`. `errors` are the errors of the
/// readings after subtracting one constant; `uncorrected` comes from uncorrected_rms().
[[nodiscard]] Trust trust_on(const Model& model, const Metrics& errors, double uncorrected,
                             const Beyond& beyond);

}  // namespace raceway::correction
