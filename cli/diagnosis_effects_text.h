#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/diagnosis.h"

namespace raceway::cli {

inline constexpr int error_digits = 3;

/// The error of one channel; "-" where it has none.
[[nodiscard]] std::string channel_error(const std::vector<double>& errors, std::size_t k,
                                        const verdict::Diagnosis& d);

/// Returns a table of the `most` best effects, one line each, and how many more there are.
[[nodiscard]] std::string effects_text(const verdict::Diagnosis& d, std::size_t most);
/// Effects that were tried, best first: errors, gain, size.
void print_effects(const verdict::Diagnosis& d);
/// Intervals of the sizes in the verdict, and what becomes of the base parameters.
void print_intervals(const verdict::Diagnosis& d);
/// Other base models that were tried.
void print_other_bases(const verdict::Diagnosis& d);

}  // namespace raceway::cli
