#pragma once

#include <string>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::loop {

/// Contents of a record, and the parts of a model that it can test.
struct Check {
  struct Column {
    const record::Channel* channel = nullptr;
    double lower = unset, upper = unset;  ///< SI
    int levels = 0;  ///< number of different values, at the resolution of files
  };
  struct MeasuredChannel {
    const record::Channel* channel = nullptr;
    int rows = 0;  ///< number of rows with a reading
    fit::Noise noise{};
    double found_noise =
        unset;  ///< rms noise as calibrate() and diagnose() find it [SI]; NaN: unknown
  };
  struct Testable {
    std::string id;
    std::string ruled_out;  ///< reason why the effect cannot act here; empty if it can
    std::string missing;    ///< input that the record or the model lacks; empty if testable
    std::string levels;  ///< levels without which base parameters act almost alike; empty if none
  };
  int rows = 0, runs = 0;
  std::vector<MeasuredChannel> measured;  ///< channels predicted by the subject first, then others
  std::vector<Column> columns;
  std::vector<record::Parameter> free;  ///< free parameters, identifiable or not
  std::string problem;  ///< reason why the free parameters cannot be fitted; empty if they can
  /// Settings with a different value in every run, as text. Setting up the rig anew for each run
  /// could have the same effect on the readings. The text is empty if there are no such settings.
  std::string runs_coincide_with;
  /// one entry for each effect, in the order of Subject::catalogue()
  std::vector<Testable> catalogue;
};

/// Checks a record. `judged` is the record for calibrate() and diagnose(), in which means of dwells
/// replace rows; null if it is the same record.
[[nodiscard]] Check check(const fit::Subject& subject, const record::Record& record,
                          const record::Record* judged = nullptr);

}  // namespace raceway::loop
