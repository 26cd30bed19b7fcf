#pragma once

#include <string>

#include "files/detail/model_section.h"
#include "record/expression.h"
#include "record/units.h"

/// Reads tables of a model file that contain a formula of the user.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> formula_tables();

/// A parameter of a formula in a model file.
struct FormulaNumber {
  std::string name, unit = "1";
  double value = 0.0;
  double lower = unset, upper = unset;  ///< bounds for a fit; NaN: no bound
  bool in_braces = false;  ///< true: written as `c = { value = ... }`; false: as `c = 0.0`
};

/// Reads a parameter of the formula of the effect `id`: `c = { value = 0.0, unit = "N mm", lower =
/// 0.0 }`, or the short form `c = 0.0`. `taken`: names that a parameter must not have.
[[nodiscard]] FormulaNumber read_formula_number(const Section& s, const std::string& id,
                                                const std::string& name, const toml::node& node,
                                                const Names& taken);

/// Throws InputError for an error in the formula of `key`. The message contains file, line and
/// column, and the formula with a mark below the error. `known`: names that the formula may use.
[[noreturn]] void fail_formula(const Section& s, const std::string& key, const std::string& id,
                               const std::string& formula, const record::FormulaError& error,
                               const Names& known);

}  // namespace raceway::files
