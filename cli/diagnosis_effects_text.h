#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/diagnosis.h"

namespace raceway::cli {

inline constexpr int error_digits = 3;

/// Returns the error `errors[k]` [SI] of channel k as text in the unit of the channel. The text is
/// "-" if `errors` has no element k. The text does not contain the unit.
[[nodiscard]] std::string channel_error(const std::vector<double>& errors, std::size_t k,
                                        const verdict::Diagnosis& d);

/// Returns a table of the best effects, with at most `most` effects. A line below the table gives
/// the number of effects that the table omits.
[[nodiscard]] std::string effects_text(const verdict::Diagnosis& d, std::size_t most);
/// Prints the tested effects, best first, with the errors and the likelihood gain of the model with
/// the effect, and with the fitted parameters of the effect.
void print_effects(const verdict::Diagnosis& d);
/// Prints confidence intervals for the parameters of the effects in the verdict. Also prints the
/// parameters of the base law from two fits, without and with these effects.
void print_intervals(const verdict::Diagnosis& d);
/// Prints gain, errors and parameters of each further base model that the diagnosis tried, one line
/// for each model.
void print_other_bases(const verdict::Diagnosis& d);

}  // namespace raceway::cli
