#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace raceway::record {

/// Exception for an invalid formula, with the position of the error.
struct FormulaError : std::invalid_argument {
  FormulaError(const std::string& what, std::size_t where, std::string which)
      : std::invalid_argument(what), position(where), unknown_name(std::move(which)) {}
  std::size_t position;      ///< number of bytes before the error in the formula
  std::string unknown_name;  ///< name that is not defined; empty for other errors
};

/// User-defined formula with the operators and functions of the library muParser. Several threads
/// may evaluate one formula at the same time.
class Expression {
 public:
  /// `names` are the variables that the formula may use. Throws FormulaError for an invalid
  /// formula, and for a variable that is not in `names`.
  Expression(std::string text, std::vector<std::string> names);
  ~Expression();

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns the indices in `names` of the variables that the formula uses, in ascending order.
  [[nodiscard]] const std::vector<std::size_t>& used() const { return used_; }
  /// Evaluates the formula. `values` are the values of the variables in used(), in the same order.
  /// The result is NaN if the formula has no value for `values`, for example if it contains the
  /// logarithm of a negative number.
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
