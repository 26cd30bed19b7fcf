#pragma once

#include <span>
#include <string>
#include <vector>

#include "verdict/diagnosis.h"
#include "verdict/hidden_input.h"

// Builds the sentences of a verdict, in the units of the files.
namespace raceway::verdict {

/// Joins words to a list such as "a, b and c". `last` is the word before the last item ("and").
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* last);
[[nodiscard]] std::string p_text(double p);

/// Returns a value with its unit: "3.21 N", or "3.21" if the unit is "1".
[[nodiscard]] std::string with_unit(double value, const std::string& unit, int digits = 3);
/// Returns the unit of a difference between two values of a quantity, for example K if the unit of
/// the quantity is C.
[[nodiscard]] std::string_view unit_of_difference(const record::Channel& channel);
/// Returns an error or another difference of readings as text, in the unit of unit_of_difference().
/// `value` is in SI units.
[[nodiscard]] std::string reading_text(const record::Channel& channel, double value,
                                       int digits = 3);

/// Returns the sentence for the verdict `nothing_missing`. The sentence names up to three effects
/// that the data would have shown, and up to three effects that the data could not show.
[[nodiscard]] std::string nothing_missing_text(const Diagnosis& d);
/// Returns the sentence for a model whose held-out error is within the tolerance. The sentence
/// names the effects in Diagnosis::significant_but_immaterial.
[[nodiscard]] std::string within_tolerance_text(const Diagnosis& d);
/// Returns a text with the RMS errors of the fits without and with the effects. If no tolerance is
/// given, the text also contains the held-out errors.
[[nodiscard]] std::string error_text(const Diagnosis& d);
/// Returns a text that says by how many percent the free parameters are too high or too low if the
/// effects of the verdict are left out of the fit. The text is empty if all these errors are below
/// 1 %.
[[nodiscard]] std::string shift_text(const Diagnosis& d);
/// Returns warnings about fitted parameters of the model that are more than three times beyond
/// the range seen in practice.
[[nodiscard]] std::vector<record::Note> unusual_values(std::span<const record::Parameter> fitted);
/// Returns false if the gains of the rival explanations should still be too near to each other
/// after the suggested measurements.
[[nodiscard]] bool will_decide(const Diagnosis& d);
/// Returns a text with up to three suggested measurements and with further quantities to record.
/// The text states two predicted differences between the gains of the rival explanations: after all
/// suggested measurements, and after a mere repetition of the present measuring points. The text is
/// empty if there are no suggestions.
[[nodiscard]] std::string measure_text(const Diagnosis& d);
/// Returns a text about two rows that have nearly equal inputs and different readings. `hidden`
/// names these rows.
[[nodiscard]] std::string difference_text(const record::Record& record, const HiddenInput& hidden);

}  // namespace raceway::verdict
