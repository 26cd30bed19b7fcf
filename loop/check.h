#pragma once

#include <string>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::loop {

/// Contents of a record, and the parts of a subject that it can test.
struct Check {
  struct Column {
    const record::Channel* channel = nullptr;
    double lower = unset, upper = unset;  ///< SI
    int levels = 0;                       ///< different values, as far as files distinguish them
  };
  struct MeasuredChannel {
    const record::Channel* channel = nullptr;
    int rows = 0;  ///< at which it was read
    fit::Noise noise{};
    double found_noise =
        unset;  ///< rms as calibrate() and diagnose() find it [SI]; NaN: they cannot
  };
  struct Testable {
    std::string id;
    std::string ruled_out;  ///< why it cannot be at work here; empty if it can
    std::string missing;    ///< input that the record or the subject lacks; empty if testable
    std::string levels;     ///< without which base parameters do nearly the same; empty if none
  };
  int rows = 0, runs = 0;
  std::vector<MeasuredChannel> measured;  ///< predicted by the subject first, then others
  std::vector<Column> columns;
  std::vector<record::Parameter> free;  ///< identifiable or not
  std::string problem;  ///< why the free parameters cannot be fitted; empty if they can
  /// Settings of which every run has its own value, in words: a rig set up anew would do what they
  /// do. Empty if there are none.
  std::string runs_coincide_with;
  std::vector<Testable> catalogue;  ///< in the order of Subject::catalogue()
};

/// `judged`: the record as calibrate() and diagnose() get it, with the means of dwells in place of
/// rows; null: the same.
[[nodiscard]] Check check(const fit::Subject& subject, const record::Record& record,
                          const record::Record* judged = nullptr);

}  // namespace raceway::loop
