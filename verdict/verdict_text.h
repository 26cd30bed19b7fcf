#pragma once

#include <string>
#include <vector>

#include "verdict/diagnosis.h"
#include "verdict/hidden_input.h"

// Words of the sentences of a verdict, in the units of the files.
namespace raceway::verdict {

/// "a, b and c", `last` being the word before the last.
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* last);
[[nodiscard]] std::string p_text(double p);

/// "3.21 N", or "3.21" where the unit is "1".
[[nodiscard]] std::string with_unit(double value, const std::string& unit, int digits = 3);
/// K of a temperature in C.
[[nodiscard]] std::string_view unit_of_difference(const record::Channel& channel);
/// A reading in the unit of its channel, with it.
[[nodiscard]] std::string reading_text(const record::Channel& channel, double value,
                                       int digits = 3);

/// The sentence of `nothing_missing`: what would have been found, and what could not.
[[nodiscard]] std::string nothing_missing_text(const Diagnosis& d);
/// The sentence where what may be missing does not matter.
[[nodiscard]] std::string within_tolerance_text(const Diagnosis& d);
/// Error before and after, in sample and on the blocks held out.
[[nodiscard]] std::string error_text(const Diagnosis& d);
/// Errors of the base parameters without the verdict, from 1 %; empty if none.
[[nodiscard]] std::string shift_text(const Diagnosis& d);
/// The first of the measurements that are suggested; empty if none.
[[nodiscard]] std::string measure_text(const Diagnosis& d);
/// Two rows that should read alike.
[[nodiscard]] std::string difference_text(const record::Record& record, const HiddenInput& hidden);

}  // namespace raceway::verdict
