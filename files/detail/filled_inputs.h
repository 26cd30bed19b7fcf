#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/record.h"

/// Fills missing values of inputs in time records.
namespace raceway::files {

/// Result of fill_input().
struct FilledInput {
  std::string note{};                ///< note for the user; empty if no value was missing
  std::vector<std::size_t> empty{};  ///< rows that still have no value
  std::vector<std::size_t> far{};    ///< rows of a temperature in gaps longer than `longest`
  double longest = unset;  ///< limit for the length of a gap [s]; NaN for a control setting
};

/// Fills the missing values of an input, run by run. Values are missing because sensors have
/// different sampling rates, and because some programs write a value only when it changes. A
/// control setting, such as a speed, keeps its value until the next one; before its first value in
/// a run, it stays empty. A temperature is interpolated linearly between readings, and it is
/// constant before the first and after the last reading of a run. The rows of a gap are in `far` if
/// the gap is longer than 10 times the median time between readings and longer than 5 minutes. If a
/// run has no reading of a temperature, the temperature stays empty in this run, and the rows of
/// the run are in `empty` and `far`.
[[nodiscard]] FilledInput fill_input(const record::Channel& channel, record::Record& data);

}  // namespace raceway::files
