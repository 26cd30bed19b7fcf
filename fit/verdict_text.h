#pragma once

#include <string>
#include <vector>

#include "fit/data_set.h"
#include "fit/diagnose.h"
#include "fit/hidden_input.h"

// Words of the sentences of a verdict. Torques in N mm, speeds in rpm, as in the files.
namespace raceway::fit {

/// "a, b and c", `last` being the word before the last.
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* last);
[[nodiscard]] std::string p_text(double p);

/// The sentence of `nothing_missing`: what would have been found, and what could not.
[[nodiscard]] std::string nothing_missing_text(const Diagnosis& d);
/// Error before and after, in sample and on the blocks held out.
[[nodiscard]] std::string error_text(const Diagnosis& d);
/// How wrong the base parameters had been, from a hundredth on; empty if none.
[[nodiscard]] std::string shift_text(const Diagnosis& d);
/// The first of the measurements that are suggested; empty if none.
[[nodiscard]] std::string measure_text(const Diagnosis& d);
/// Two rows that should read alike.
[[nodiscard]] std::string difference_text(const DataSet& data, const HiddenInput& hidden);

}  // namespace raceway::fit
