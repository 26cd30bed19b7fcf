#pragma once

#include <string>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::loop {

/// Result of check(): content of a record, parameters that can be fitted to the record, and effects
/// that the record can test.
struct Check {
  struct Column {
    const record::Channel* channel = nullptr;
    double lower = unset, upper = unset;  ///< range of the values [SI]
    int levels = 0;  ///< number of different values; values are rounded to 0.001 of the unit
  };
  struct MeasuredChannel {
    const record::Channel* channel = nullptr;
    int rows = 0;  ///< number of rows with a reading
    fit::Noise noise{};
    /// RMS noise that diagnose() estimates from the readings [SI]; NaN if diagnose() cannot
    /// estimate the noise.
    double found_noise = unset;
  };
  struct Testable {
    std::string id;
    std::string ruled_out;  ///< reason why the effect cannot act in this model; empty if it can
    /// Input that a test of the effect needs and that the record or the model lacks; empty if none
    /// is lacking.
    std::string missing;
    /// Input that has too few different values in the record to test the effect, as text; empty if
    /// the values suffice.
    std::string levels;
  };
  int rows = 0, runs = 0;
  /// Measured channels of the record. The channels that the model predicts come first.
  std::vector<MeasuredChannel> measured;
  std::vector<Column> columns;
  std::vector<record::Parameter> free;  ///< all free parameters, even if not identifiable
  std::string problem;  ///< reason why the free parameters cannot be fitted; empty if they can
  /// Names of settings that are constant within each run and different in every run; empty if there
  /// are none. If the rig was set up again before each run, the record cannot separate the effect
  /// of the setup from the effect of these settings.
  std::string runs_coincide_with;
  /// One entry for each effect, in the order of Subject::catalogue().
  std::vector<Testable> catalogue;
};

/// Checks which parameters can be fitted to a record and which effects the record can test.
/// `judged` is `record` after averaging over dwells (fit::average_dwells()). `free`, `problem` and
/// `found_noise` are computed from `judged` or, if it is null, from `record`.
[[nodiscard]] Check check(const fit::Subject& subject, const record::Record& record,
                          const record::Record* judged = nullptr);

}  // namespace raceway::loop
