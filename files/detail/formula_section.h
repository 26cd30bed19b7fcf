#pragma once

#include <string>

#include "files/detail/model_section.h"
#include "record/expression.h"
#include "record/units.h"

/// Functions shared by sections with a user-made formula.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> formula_tables();

/// A parameter of a formula.
struct FormulaNumber {
  std::string name, unit = "1";
  double value = 0.0;
  double lower = unset, upper = unset;  ///< NaN: no bound
  bool in_braces = false;
};

/// `c = { value = 0.0, unit = "N mm", lower = 0.0 }` or short `c = 0.0`, of the formula of `id`.
/// `taken`: names that it may not have.
[[nodiscard]] FormulaNumber read_formula_number(const Section& s, const std::string& id,
                                                const std::string& name, const toml::node& node,
                                                const Names& taken);

/// Throws InputError: file, line and column of the error in the formula under `key`, and the
/// formula with a mark under the error. `known`: the names that it may use.
[[noreturn]] void fail_formula(const Section& s, const std::string& key, const std::string& id,
                               const std::string& formula, const record::FormulaError& error,
                               const Names& known);

}  // namespace raceway::files
