#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verdict/diagnosis.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

struct DiagnoseOptions {
  /// Effects that may be missing, by id; empty: all candidates of the subject.
  std::vector<std::string> candidates{};
  int tried_before = 0;  ///< other candidates once tried on these data, for the multiplicity
  int most_rows = most_rows_of_a_fit;
  bool pairs = true;
  /// Tries the subject's other base models too if no candidate explains the misfit.
  bool other_bases = true;
  fit::NoiseOptions noise{};
  std::function<void(double share, std::string_view step)> progress{};
  const std::atomic<bool>* cancelled = nullptr;  ///< diagnose() throws Cancelled once it is set
};

/// Says whether an effect is missing in the subject, which, or what to measure to find out.
///
///   noise from a saturated regression -> gate (smooth misfit, largest score) -> each candidate
///   alone, then pairs and triples, refitted with all base parameters -> gate again on the
///   residuals
///   -> blocked hold-out, plausible size -> next measurements
///
/// Level of the gate: 1 %. An effect is admitted where -2 ln L falls by more than ln N + 2 ln m,
/// and is named with all others within 6 of the best.
///
/// If no candidate explains the misfit, or one only acts like it, the other base models
/// (Subject::other_bases()) are calibrated to the readings and compared like candidates. The
/// verdict is still about the model as given.
///
/// Fewer than 15 rows do not tell their noise: from 8 on it is the declared one, and only
/// candidates of one number are tried, alone.
///
/// If a channel has a tolerance (Measured::tolerance), the question is whether a missing effect
/// matters on held-out blocks within the measured range: nothing is missing if the refitted model
/// stays within the tolerance there; an effect explains the data if it brings the error within, as
/// do all that come as near by a fifth; two effects do if no single one does and they gain a fifth.
/// Throws std::invalid_argument where the data cannot carry a verdict, and Cancelled. Not for a
/// subject that only approximates: see loop/loop.h.
[[nodiscard]] Diagnosis diagnose_by_noise(const fit::Subject& subject, const record::Record& record,
                                          const DiagnoseOptions& options = {});

}  // namespace raceway::verdict
