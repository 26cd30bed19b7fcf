#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/record.h"

/// Shared by the readers of records over time.
namespace raceway::files {

/// What was filled of an input, and what could not be.
struct FilledInput {
  std::string note{};                ///< empty where nothing was missing
  std::vector<std::size_t> empty{};  ///< rows before the first value of what holds
  std::vector<std::size_t> far{};    ///< rows in gaps longer than `longest`
  double longest = unset;            ///< [s]; NaN of what holds
};

/// Fills the rows in which an input was not read, within its run: sensors have rates of their own,
/// and some programs write a value when it changes. What a control sets holds until its next value.
/// A temperature goes in a straight line from one reading to the next, and stays at the ends of a
/// run; what is longer than 10 times the usual time between its readings, and than 5 minutes, is
/// `far`. One without any reading in a run stays empty there, and is `far`.
[[nodiscard]] FilledInput fill_input(const record::Channel& channel, record::Record& data);

}  // namespace raceway::files
