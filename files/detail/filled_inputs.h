#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/record.h"

/// Filling of missing inputs; shared by the readers of records over time.
namespace raceway::files {

/// Filled and missing values of an input.
struct FilledInput {
  std::string note{};                ///< empty if no value was missing
  std::vector<std::size_t> empty{};  ///< rows before the first value of a setting
  std::vector<std::size_t> far{};    ///< rows in gaps longer than `longest`
  double longest = unset;            ///< [s]; NaN for a setting
};

/// Fills the rows without a value of an input, run by run. Such rows exist because sensors have
/// different sampling rates, and some programs write a value only when it changes. A control
/// setting is constant until its next value. A temperature is interpolated linearly, and it is
/// constant at the ends of a run. The rows of a gap are `far` if the gap is longer than 10 times
/// the usual time between readings and longer than 5 minutes. A temperature without a reading in a
/// run stays empty in that run, and these rows are `far`.
[[nodiscard]] FilledInput fill_input(const record::Channel& channel, record::Record& data);

}  // namespace raceway::files
