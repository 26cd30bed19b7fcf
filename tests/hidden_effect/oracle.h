#pragma once

#include <optional>
#include <span>
#include <string>

#include "tests/hidden_effect/generator.h"

namespace hidden_effect {

/// Likelihoods of one record for an observer who knows the formula of the base law, the true cause
/// and the covariance of the noise. The sizes of all causes and the numbers of the base law are
/// free. All figures are differences of -2 ln L.
struct OracleAnswer {
  /// A truth with a cause: its lead over the base law alone; two causes: over the best single one.
  /// Nothing hidden: zero.
  double gain = 0.0;
  /// Lead of the truth over the best rival with as many causes. Nothing hidden: over the best
  /// single cause, so at most zero.
  double lead = 0.0;
  std::string rival;        ///< which one that is
  double least_loss = 0.0;  ///< by which the fit gets worse without the weaker of two causes
  /// Lead of the best right entry of the catalogue over all other entries. Unset: no entry is
  /// right.
  std::optional<double> entry_lead;
  /// A truth outside the catalogue, for an observer who does not know its formula: excess of the
  /// least squared misfit of all entries over the limit that noise exceeds in 1 %.
  std::optional<double> misfit_excess;

  double detected_from = 0.0;  ///< gain over the base law that chance exceeds in 1 %
  double detection = 0.0;      ///< lead of the truth over the base law
  double needed = 0.0;         ///< gain that admits a name, as in the diagnosis
  /// Gain and limit of an observer who does not know the size of the run offsets and learns it from
  /// the record. For a wrong datum: gain of the datum, with the limit of Student's distribution for
  /// as many candidates as the diagnosis tries. For zeros that are set before each run, with
  /// nothing hidden: gain of the best single cause.
  std::optional<double> learned_detection;
  double learned_from = 0.0;
  bool something = false;  ///< a cause is hidden

  /// A cause is hidden: a test of the truth against nothing at 1 % finds it. Otherwise: the best
  /// single cause gets admitted.
  [[nodiscard]] bool detects() const;
  /// The truth is admitted and no rival is ahead of it by more than `within_reach`.
  [[nodiscard]] bool includes() const;
  /// The truth is admitted and ahead of each rival by more than `within_reach`.
  [[nodiscard]] bool decides() const;
  /// A rival is admitted and ahead of the truth by more than `within_reach`. Nothing is hidden: the
  /// best single cause is admitted.
  [[nodiscard]] bool misnames() const;
};

/// Distance in -2 ln L within which the diagnosis names two causes together.
constexpr double within_reach = 6.0;

/// Returns nothing for loggers, more than two causes, and wrong data that are not in
/// data_of_the_files(). Rivals: each entry of the catalogue and each datum alone, two causes: each
/// pair of entries; for a creeping zero also zeros that are set before each run, with an unknown
/// scatter.
[[nodiscard]] std::optional<OracleAnswer> ask_oracle(const Rig& rig, std::span<const Reading> rows);

}  // namespace hidden_effect
