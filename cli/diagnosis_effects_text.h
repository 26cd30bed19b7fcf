#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/diagnosis.h"

namespace raceway::cli {

inline constexpr int error_digits = 3;

/// Returns the error `errors[k]` [SI] of channel k as text in the unit of the channel; "-" if
/// `errors` has no element k. The text does not contain the unit.
[[nodiscard]] std::string channel_error(const std::vector<double>& errors, std::size_t k,
                                        const verdict::Diagnosis& d);

/// Returns a table of at most `most` effects, best first, and the number of further effects.
[[nodiscard]] std::string effects_text(const verdict::Diagnosis& d, std::size_t most);
/// Prints the tested effects, best first, with their errors, gains and sizes.
void print_effects(const verdict::Diagnosis& d);
/// Prints confidence intervals for the sizes of the effects in the verdict, and the changes of the
/// base parameters.
void print_intervals(const verdict::Diagnosis& d);
/// Prints the other base models that the diagnosis has tested.
void print_other_bases(const verdict::Diagnosis& d);

}  // namespace raceway::cli
