#pragma once

#include <string>
#include <string_view>

#include "correction/metrics.h"
#include "correction/model.h"
#include "correction/range.h"

/// Trust in a correction, from the evidence of readings that no fit saw.
namespace raceway::correction {

enum class TrustLevel { unknown, do_not_use, within_range, good };

/// "unknown", "do-not-use", "within-range", "good"
[[nodiscard]] std::string_view name(TrustLevel level);

struct Trust {
  TrustLevel level = TrustLevel::unknown;
  std::string because{};  ///< one clause; empty where it is good
};

/// Returns the line for people: "good", "inside its range only: ...", "do not use, because ...",
/// "not known: ...".
[[nodiscard]] std::string line_of(const Trust& trust);

/// RMS of the readings when one constant is taken off each run: the error without a correction [m].
[[nodiscard]] double uncorrected_rms(const Model& model, const record::Record& record);

/// Evidence of a record that a model was fitted to. `error`: RMS on readings that no fit saw [m],
/// NaN where nothing could be held out.
[[nodiscard]] Evidence evidence_on(const Model& model, const record::Record& record, double error);

/// Returns the trust that the evidence of a model supports. The first that applies:
///
///   do not use    nothing was held out; the readings go from one state to another once; a time
///                 constant is longer than the readings; more than half of the mean square of the
///                 displacement is left
///   within range  a time constant is longer than a third of the readings; the error is above the
///                 tolerance, or without one above a quarter of the displacement
///   good          otherwise
///
/// An error on another record (`Evidence::other_record`) shows by itself what the course and the
/// length of the first record can only suggest, and these are not asked then.
/// Accuracy: the limits are ours. Of corrections found in the first 1 to 12 h of
/// data/corrections/exact, none that leaves more than a fifth of the displacement of its
/// test.csv is called good.
[[nodiscard]] Trust trust_of(const Model& model);

/// Trust on a record: no better than its readings show, and within its range only where the record
/// leaves it. `errors`: of the readings, one constant subtracted; `uncorrected`: as above.
[[nodiscard]] Trust trust_on(const Model& model, const Metrics& errors, double uncorrected,
                             const Beyond& beyond);

}  // namespace raceway::correction
