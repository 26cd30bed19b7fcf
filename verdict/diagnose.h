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
  /// Ids of the effects that may be missing; empty means all candidates for the model.
  std::vector<std::string> candidates{};
  /// Number of candidates tried earlier on these data, for the multiple-testing correction.
  int tried_before = 0;
  int most_rows = most_rows_of_a_fit;
  bool pairs = true;
  /// If true, other base models (Subject::other_bases()) are also tried when no candidate explains
  /// the misfit, or when one candidate fits only with another law or an implausible size.
  bool other_bases = true;
  fit::NoiseOptions noise{};
  std::function<void(double share, std::string_view step)> progress{};
  /// null, or a flag; if it becomes true, diagnose() throws fit::Cancelled
  const std::atomic<bool>* cancelled = nullptr;
};

/// Tests whether the model misses an effect, and identifies this effect or suggests measurements
/// that would identify it.
///
///   1. noise from a saturated regression
///   2. gate: test for any missing effect, by an F test and a score test (Gate in verdict/gate.h)
///   3. refit of all base parameters with each candidate alone, then with pairs and triples
///   4. gate again, on the residuals of these fits
///   5. test on held-out blocks of rows, and check whether the sizes are plausible
///   6. next measurements, if the data cannot decide
///
/// The gate tests at a level of 1 % whether any effect is missing. An effect is accepted only if
/// its gain (RankedEffect::gain) exceeds ln N + 2 ln m, with N readings and m tried candidates. The
/// verdict names the best effect, and all effects whose gain is at most 6 below the gain of the
/// best effect.
///
/// The other base models (Subject::other_bases()) are calibrated to the readings and compared like
/// candidates in two cases: no candidate explains the misfit, or one candidate fits only with
/// another law or an implausible size. The verdict always refers to the given model.
///
/// The noise cannot be estimated from fewer than 15 readings, or fewer than p + 12 readings for p
/// free parameters. In this case, the declared standard deviations are used as the noise if every
/// reading has one and there are at least 8 and at least p + 4 readings. Only candidates with one
/// parameter are then tried, one at a time.
///
/// If a channel has a tolerance (Measured::tolerance), the held-out error within the measured range
/// decides, after subtraction of the noise: sqrt(error² - noise²). Nothing is missing if the gate
/// gives no alarm, or if the error of the refitted model is within the tolerance. An effect
/// explains the data if its gain exceeds ln N + 2 ln m, its size is plausible, and the error with
/// this effect is within the tolerance. Effects whose error is at most a fifth larger than the
/// smallest error are also named. Two effects explain the data if no single effect does, if the
/// pair brings the error within the tolerance, and if the error of the best single effect is at
/// least a fifth larger than the error of the pair.
///
/// Throws std::invalid_argument if the data cannot give a verdict (the message says what is
/// needed), and fit::Cancelled if the caller cancels. For models that only approximate the readings
/// (Subject::approximates()), use diagnose() in loop/loop.h.
[[nodiscard]] Diagnosis diagnose_by_noise(const fit::Subject& subject, const record::Record& record,
                                          const DiagnoseOptions& options = {});

}  // namespace raceway::verdict
