#include "record/expression.h"

#include <muParser.h>

#include <algorithm>
#include <mutex>

#include "record/units.h"

namespace raceway::record {
namespace {

/// What muParser takes and nobody means: several expressions, of which the last would count, and
/// values given to names. Operators of other languages get a hint.
void refuse_what_is_no_formula(const std::string& text) {
  const auto refuse = [](const std::string& what, std::size_t where) {
    throw FormulaError(what, where, "");
  };
  if (const std::size_t at = text.find("**"); at != text.npos)
    refuse("** is not an operator in formulas; write a power as x^2", at);
  for (std::size_t at = text.find('='); at != text.npos; at = text.find('=', at + 1)) {
    const char before = at > 0 ? text[at - 1] : ' ';
    if (at + 1 < text.size() && text[at + 1] == '=')
      ++at;
    else if (before != '<' && before != '>' && before != '!')
      refuse("a formula cannot assign a value with =; write == to compare", at);
  }
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (text[at] == ',' && depth <= 0)
      refuse(
          "a comma may only separate the arguments of a function; write decimals with a point, 1.5",
          at);
    if (text[at] == ';') refuse("a formula is a single expression; remove the ;", at);
  }
}

}  // namespace

/// A parser and the numbers it looks at; muParser keeps them by address.
struct Expression::Instance {
  mu::Parser parser;
  std::vector<double> numbers;

  Instance(const std::string& text, const std::vector<std::string>& names)
      : numbers(names.size(), 1.0) {
    for (std::size_t k = 0; k < names.size(); ++k) parser.DefineVar(names[k], &numbers[k]);
    parser.SetExpr(text);
    (void)parser.Eval();
  }
};

/// Parsers at rest. A thread takes one and puts it back, so that none is shared.
struct Expression::Pool {
  std::mutex lock;
  std::vector<std::unique_ptr<Instance>> at_rest;
};

Expression::Expression(std::string text, std::vector<std::string> names)
    : text_(std::move(text)), names_(std::move(names)), pool_(new Pool) {
  refuse_what_is_no_formula(text_);
  try {
    auto first = std::make_unique<Instance>(text_, names_);
    for (const auto& [name, address] : first->parser.GetUsedVar())
      used_.push_back(static_cast<std::size_t>(address - first->numbers.data()));
    std::sort(used_.begin(), used_.end());
    pool_->at_rest.push_back(std::move(first));
  } catch (const mu::Parser::exception_type& error) {
    const bool unknown = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN;
    const int position = error.GetPos();
    const std::string token = error.GetToken();
    std::string message = error.GetMsg();
    if (unknown) message = "\"" + token + "\" is not known";
    throw FormulaError(
        message,
        position < 0 ? text_.size() : std::min(static_cast<std::size_t>(position), text_.size()),
        unknown ? token : "");
  }
}

Expression::~Expression() = default;

double Expression::operator()(std::span<const double> values) const {
  std::unique_ptr<Instance> mine;
  {
    const std::lock_guard hold(pool_->lock);
    if (!pool_->at_rest.empty()) {
      mine = std::move(pool_->at_rest.back());
      pool_->at_rest.pop_back();
    }
  }
  if (!mine) mine = std::make_unique<Instance>(text_, names_);
  for (std::size_t k = 0; k < used_.size(); ++k) mine->numbers[used_[k]] = values[k];
  double result = unset;
  try {
    result = mine->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    // No number at this point, as where an argument is out of range: NaN says so.
  }
  const std::lock_guard hold(pool_->lock);
  pool_->at_rest.push_back(std::move(mine));
  return result;
}

}  // namespace raceway::record
