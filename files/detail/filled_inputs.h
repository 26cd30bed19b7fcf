#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/record.h"

/// Shared by the readers of records over time.
namespace raceway::files {

/// Filled and missing values of an input.
struct FilledInput {
  std::string note{};                ///< empty if no value was missing
  std::vector<std::size_t> empty{};  ///< rows before the first value of a setting
  std::vector<std::size_t> far{};    ///< rows in gaps longer than `longest`
  double longest = unset;            ///< [s]; NaN for a setting
};

/// Fills the rows in which an input was not read, within its run: sensors have different rates, and
/// some programs write a value only when it changes. A control setting is constant until its next
/// value. A temperature is interpolated linearly and constant at the ends of a run. A gap longer
/// than 10 times the usual time between its readings, and longer than 5 minutes, is `far`. One
/// without any reading in a run stays empty there, and is `far`.
[[nodiscard]] FilledInput fill_input(const record::Channel& channel, record::Record& data);

}  // namespace raceway::files
