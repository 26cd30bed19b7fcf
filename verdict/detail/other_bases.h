#pragma once

#include <string>
#include <vector>

#include "verdict/attribution.h"

/// Parts of diagnose() and add().
namespace raceway::verdict {

/// Another base model, calibrated to the readings of a diagnosis under the noise found there.
struct CalibratedBase {
  fit::OtherBase base{};
  /// Without members; its parameters are the free numbers of that base model. The gain is the fall
  /// of -2 ln L against the refitted model as given, less ln N for each number that is free beyond
  /// those of the given one.
  Explanation explanation{};
  std::string not_testable{};  ///< why not, in a sentence; empty where it can be tested
};

[[nodiscard]] CalibratedBase calibrate_other_base(const Evidence& evidence, fit::OtherBase base);

/// All that the subject offers, the best first; those that cannot be tested come last.
[[nodiscard]] std::vector<CalibratedBase> calibrate_other_bases(const Evidence& evidence);

/// The subject of one of them with the values that were found.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted_subject(const CalibratedBase& found);

}  // namespace raceway::verdict
