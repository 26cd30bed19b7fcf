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
  /// Ids of the candidates, which are effects that may be missing or data that may be wrong. If the
  /// list is empty, all candidates that are possible in the model are tested.
  std::vector<std::string> candidates{};
  /// Number of candidates tried earlier on these data, for the multiple-testing correction.
  int tried_before = 0;
  int most_rows = most_rows_of_a_fit;
  bool pairs = true;
  /// True: other base laws (Subject::other_bases()) are also tried if the verdict is `effect_like`
  /// or `not_in_catalogue`.
  bool other_bases = true;
  fit::NoiseOptions noise{};
  std::function<void(double share, std::string_view step)> progress{};
  /// Flag with which the caller can cancel; may be null. The diagnosis throws fit::Cancelled when
  /// the flag is true.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Tests whether an effect is missing in the model. If so, the function identifies the effect or
/// suggests measurements that would identify it. The steps are:
///
///   1. estimate of the noise: residuals of a regression of the readings on smooth functions of the
///      inputs and on the changes that the candidates cause
///   2. test for any missing effect, by an F test and a score test (Gate in verdict/gate.h)
///   3. refit of all base parameters with each candidate alone, then with pairs and triples
///   4. test of step 2 again, with the residuals of the fits of step 3
///   5. test on held-out blocks of rows, and check for implausible sizes
///   6. choice of the next measurements, if the data cannot separate the effects
///
/// The test for a missing effect has a significance level of 1 %. An effect is accepted only if its
/// gain (RankedEffect::gain) exceeds ln N + 2 ln m, with N readings and m tried candidates. The
/// verdict names the best effect, and all effects whose gain is at most 6 below the gain of the
/// best effect.
///
/// If the verdict is `effect_like` or `not_in_catalogue`, other base laws (Subject::other_bases())
/// are also fitted to the readings and compared with the candidates. The verdict always refers to
/// the base law of `subject`.
///
/// For p free parameters, the estimate of the noise needs at least max(15, p + 12) readings. If the
/// record has fewer than this number but at least max(8, p + 4) readings, each with a declared
/// standard deviation, these standard deviations replace the estimate. In a record with so few
/// readings, the function tries only candidates with one parameter, one at a time.
///
/// If a channel has a tolerance (Measured::tolerance), the verdict depends on the held-out error
/// within the measured range, after subtraction of the noise: sqrt(error² - noise²). In this list,
/// "error" means the result of the subtraction:
///   - Nothing is missing if the test finds no missing effect, or if the error of the refitted
///     model without additional effects is within the tolerance.
///   - One effect explains the data if its gain exceeds ln N + 2 ln m, its size is plausible, and
///     the error with this effect is within the tolerance. The verdict also names effects whose
///     error is at most 1.2 times the smallest error.
///   - If no single effect explains the data, pairs of effects are tested in the same way. A pair
///     is accepted only if the error with the best single effect is at least 1.2 times the error
///     with the pair.
///
/// Throws std::invalid_argument if the data cannot give a verdict (the message says what is
/// needed), and fit::Cancelled if the caller cancels. For a spindle model or a correction
/// (Subject::approximates()), use diagnose() in loop/loop.h.
[[nodiscard]] Diagnosis diagnose_by_noise(const fit::Subject& subject, const record::Record& record,
                                          const DiagnoseOptions& options = {});

}  // namespace raceway::verdict
