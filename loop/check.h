#pragma once

#include <string>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::loop {

/// Result of check(): contents of a record, parameters that can be fitted to the record, and
/// effects that the record can test.
struct Check {
  struct Column {
    const record::Channel* channel = nullptr;
    double lower = unset, upper = unset;  ///< range of the values [SI]
    int levels = 0;  ///< number of different values, rounded to 0.001 in the unit of files
  };
  struct MeasuredChannel {
    const record::Channel* channel = nullptr;
    int rows = 0;  ///< number of rows with a reading
    fit::Noise noise{};
    double found_noise =
        unset;  ///< RMS noise that diagnose() estimates from the readings [SI]; NaN: no estimate
  };
  struct Testable {
    std::string id;
    std::string ruled_out;  ///< reason why the effect cannot act in this model; empty if it can
    std::string missing;    ///< input that the record or the model lacks; empty if testable
    std::string levels;     ///< input levels that a test needs and the record lacks; empty if none
  };
  int rows = 0, runs = 0;
  /// Measured channels of the record: first the channels that the model predicts, then the others.
  std::vector<MeasuredChannel> measured;
  std::vector<Column> columns;
  std::vector<record::Parameter> free;  ///< all free parameters, even if not identifiable
  std::string problem;  ///< reason why the free parameters cannot be fitted; empty if they can
  /// Names of settings that are constant within each run and different in every run; empty if there
  /// are none. A new setup of the rig for each run could have the same effect on the readings.
  std::string runs_coincide_with;
  /// One entry for each effect, in the order of Subject::catalogue().
  std::vector<Testable> catalogue;
};

/// Checks which parameters can be fitted to a record and which effects the record can test.
/// `judged` is the record for calibrate() and diagnose(), in which means of dwells replace rows. If
/// `judged` is null, `record` is used.
[[nodiscard]] Check check(const fit::Subject& subject, const record::Record& record,
                          const record::Record* judged = nullptr);

}  // namespace raceway::loop
