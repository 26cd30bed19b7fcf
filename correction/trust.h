#pragma once

#include <string>
#include <string_view>

#include "correction/metrics.h"
#include "correction/model.h"
#include "correction/range.h"

/// Rates the trust in a correction from held-out readings.
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

/// Returns the rms of the readings after subtracting one constant from each run: the error without
/// a correction [m].
[[nodiscard]] double uncorrected_rms(const Model& model, const record::Record& record);

/// Returns the evidence of a record to which a model was fitted. `error` is the rms error on
/// held-out readings [m]; NaN if nothing could be held out.
[[nodiscard]] Evidence evidence_on(const Model& model, const record::Record& record, double error);

/// Returns the trust that the evidence of a model supports. The first matching level is used:
///
///   do not use    nothing was held out; the readings move only once from one state to another; a
///                 time constant is longer than the readings; the residual contains more than half
///                 of the mean square of the displacement
///   within range  a time constant is longer than a third of the readings; the error exceeds the
///                 tolerance or, without a tolerance, a quarter of the displacement
///   good          otherwise
///
/// An error on another record (`Evidence::other_record`) is direct evidence. The function then
/// ignores the conditions on the shape and the length of the first record.
/// Accuracy: the limits are our choice. They were tested on corrections found in the first 1 to 12
/// h of data/corrections/exact. No correction whose residual in test.csv exceeds a fifth of the
/// displacement is rated good.
[[nodiscard]] Trust trust_of(const Model& model);

/// Returns the trust for a record. The level is never better than the level that the readings of
/// the record support. If the record leaves the range, the level is at best "within range".
/// `errors` are the errors of the readings after subtracting one constant; `uncorrected` comes from
/// uncorrected_rms().
[[nodiscard]] Trust trust_on(const Model& model, const Metrics& errors, double uncorrected,
                             const Beyond& beyond);

}  // namespace raceway::correction
