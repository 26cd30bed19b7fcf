#pragma once

#include <string>
#include <vector>

#include "verdict/diagnosis.h"
#include "verdict/hidden_input.h"

// Builds the sentences of a verdict, in the units of the files.
namespace raceway::verdict {

/// Joins words as "a, b and c"; `last` is the word before the last item.
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* last);
[[nodiscard]] std::string p_text(double p);

/// Returns a value with its unit: "3.21 N", or "3.21" if the unit is "1".
[[nodiscard]] std::string with_unit(double value, const std::string& unit, int digits = 3);
/// Returns the unit of a difference: K for a temperature in C.
[[nodiscard]] std::string_view unit_of_difference(const record::Channel& channel);
/// Returns a reading as text in the unit of its channel.
[[nodiscard]] std::string reading_text(const record::Channel& channel, double value,
                                       int digits = 3);

/// Returns the sentence for `nothing_missing`, with up to three effects that would have been found
/// and up to three that could not have been found.
[[nodiscard]] std::string nothing_missing_text(const Diagnosis& d);
/// Returns the sentence for a model whose held-out error is within the tolerance, with the
/// significant effects that are not important.
[[nodiscard]] std::string within_tolerance_text(const Diagnosis& d);
/// Returns the error without and with the effects, in sample and, if no tolerance is given, on
/// held-out blocks.
[[nodiscard]] std::string error_text(const Diagnosis& d);
/// Returns the shifts of the base parameters when the effects of the verdict are left out. Only
/// shifts of 1 % or more are included; empty if there are none.
[[nodiscard]] std::string shift_text(const Diagnosis& d);
/// Returns up to three suggested measurements with the predicted separation, and the further
/// quantities to record. The text is empty if there are none.
[[nodiscard]] std::string measure_text(const Diagnosis& d);
/// Describes two rows with equal settings and different readings.
[[nodiscard]] std::string difference_text(const record::Record& record, const HiddenInput& hidden);

}  // namespace raceway::verdict
