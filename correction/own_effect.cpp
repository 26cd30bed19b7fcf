#include "correction/own_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "correction/effects/shared_numbers.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Names of a formula, each once; numbers such as 1e-3 have none.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const bool digit = text[at] >= '0' && text[at] <= '9';
    if (!is_letter(text[at]) && !digit) {
      ++at;
      continue;
    }
    const std::size_t first = at;
    while (at < text.size() && (is_letter(text[at]) || (text[at] >= '0' && text[at] <= '9'))) ++at;
    std::string word = text.substr(first, at - first);
    if (!digit && std::find(words.begin(), words.end(), word) == words.end())
      words.push_back(std::move(word));
  }
  return words;
}

record::NumberCard card_of_number(const OwnEffect::Number& n) {
  const double lower = std::isnan(n.lower) ? -any_size : n.lower;
  const double upper = std::isnan(n.upper) ? any_size : n.upper;
  return {n.name, n.unit, n.value, lower, upper, lower, upper, unset};
}

}  // namespace

const Channel* column_of_formula(std::string_view name) {
  const Channel* const c = record::series_channel(name);
  return c && (c->is_input() || *c == record::time) ? c : nullptr;
}

OwnEffect::OwnEffect(Given given) : given_(std::move(given)) {
  std::vector<std::string> names;
  for (const std::string& word : words_of(given_.formula))
    if (const Channel* const c = column_of_formula(word)) {
      columns_.push_back(c);
      names.push_back(word);
    }
  for (const Number& n : given_.parameters) names.push_back(n.name);
  expression_ = std::make_unique<record::Expression>(given_.formula, std::move(names));
  for (const std::size_t k : expression_->used())
    terms_.push_back(k < columns_.size() ? Term{true, k} : Term{false, k - columns_.size()});
  numbers_.push_back({"gain", "um", 0.0, -any_size, any_size});
  if (given_.lags) numbers_.push_back(time_constant_number);
  for (const Number& n : given_.parameters) numbers_.push_back(card_of_number(n));
  if (given_.title.empty()) given_.title = "formula of the model file";
  card_ = {
      .id = given_.id,
      .title = given_.title,
      .form = given_.formula,
      .needs = "all columns that its formula uses, and at least one of these columns must vary",
      .confused = "",
      .numbers = numbers_};
}

std::string OwnEffect::key(const Effect&, std::size_t number, const Model&) const {
  if (number == 0) return "gain_um";
  if (number < first_parameter()) return "time_constant_s";
  const Number& n = given_.parameters[number - first_parameter()];
  return n.in_braces ? n.name + ".value" : n.name;
}

Input OwnEffect::input(const Effect& effect, const Model&) const {
  return {.name = given_.id,
          .formula = effect.own,
          .formula_values = {effect.values.begin() + static_cast<std::ptrdiff_t>(first_parameter()),
                             effect.values.end()}};
}

Share OwnEffect::share(const Effect& effect, const Model& model) const {
  return DrivenShare{input(effect, model), effect.values.front(),
                     given_.lags ? effect.values[1] : unset};
}

bool OwnEffect::follows_a_temperature() const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [](const Channel* c) { return record::is_temperature(*c); });
}

double OwnEffect::value(std::span<const double> columns, std::span<const double> parameters,
                        std::vector<double>& scratch) const {
  scratch.clear();
  for (const Term& t : terms_)
    scratch.push_back(t.of_column ? columns[t.index] : parameters[t.index]);
  return (*expression_)(scratch);
}

}  // namespace raceway::correction
