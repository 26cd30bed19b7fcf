#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace raceway::record {

/// Error in a formula, and its position.
struct FormulaError : std::invalid_argument {
  FormulaError(const std::string& what, std::size_t where, std::string which)
      : std::invalid_argument(what), position(where), unknown_name(std::move(which)) {}
  std::size_t position;      ///< byte in the formula
  std::string unknown_name;  ///< empty unless a name is not known
};

/// A formula that a user wrote, in operators and functions of muParser. May be evaluated by several
/// threads at once.
class Expression {
 public:
  /// Throws FormulaError: no formula, or a name that is none of these.
  Expression(std::string text, std::vector<std::string> names);
  ~Expression();

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Indices of the names that occur in it, rising.
  [[nodiscard]] const std::vector<std::size_t>& used() const { return used_; }
  /// At values of the names that are used, in that order; NaN where there is no number.
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
