#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace raceway::record {

/// Error in a formula, with its position.
struct FormulaError : std::invalid_argument {
  FormulaError(const std::string& what, std::size_t where, std::string which)
      : std::invalid_argument(what), position(where), unknown_name(std::move(which)) {}
  std::size_t position;      ///< position in the formula [byte]
  std::string unknown_name;  ///< the unknown name; empty for other errors
};

/// A user-defined formula with operators and functions of muParser. Several threads may evaluate
/// one formula at the same time.
class Expression {
 public:
  /// Throws FormulaError for an invalid formula and for an unknown name.
  Expression(std::string text, std::vector<std::string> names);
  ~Expression();

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns the indices of the names that the formula uses, in ascending order.
  [[nodiscard]] const std::vector<std::size_t>& used() const { return used_; }
  /// Evaluates the formula. `values` are the values of the used names, in the order of used(). The
  /// result is NaN where the formula has no value, for example outside the domain of a function.
  [[nodiscard]] double operator()(std::span<const double> values) const;

 private:
  struct Instance;
  struct Pool;
  std::string text_;
  std::vector<std::string> names_;
  std::vector<std::size_t> used_;
  std::unique_ptr<Pool> pool_;
};

}  // namespace raceway::record
