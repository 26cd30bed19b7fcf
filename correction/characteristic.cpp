#include "correction/characteristic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace raceway::correction {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr Interval no_input{0.0, 0.0};

/// The nearest number to a root below 0 at which a law is still positive, when it is written.
double just_above(double root) { return root * (1.0 - 1e-12); }

double at(const Characteristic::Line& f, double x) { return f.slope * x + f.offset; }
double at(const Characteristic::Power& f, double x) { return f.factor * std::pow(x, f.exponent); }
double at(const Characteristic::Table& f, double x) {
  const auto after = std::upper_bound(f.input.begin(), f.input.end(), x);
  if (after == f.input.begin()) return f.value.front();
  if (after == f.input.end()) return f.value.back();
  const auto k = static_cast<std::size_t>(after - f.input.begin());
  const double share = (x - f.input[k - 1]) / (f.input[k] - f.input[k - 1]);
  return f.value[k - 1] + share * (f.value[k] - f.value[k - 1]);
}

Interval positive_within(const Characteristic::Line& f) {
  if (f.offset <= 0.0) return no_input;
  const double root = f.slope != 0.0 ? -f.offset / f.slope : nowhere;
  if (f.slope < 0.0) return {-nowhere, root};
  return f.slope > 0.0 ? Interval{just_above(root), nowhere} : Interval{};
}
Interval positive_within(const Characteristic::Power& f) {
  return f.factor > 0.0 ? Interval{0.0, nowhere} : no_input;
}
Interval positive_within(const Characteristic::Table& f) {
  if (at(f, 0.0) <= 0.0) return no_input;
  Interval within;
  const auto root = [&](std::size_t k) {
    return f.input[k - 1] +
           (f.input[k] - f.input[k - 1]) * f.value[k - 1] / (f.value[k - 1] - f.value[k]);
  };
  for (std::size_t k = 0; k < f.input.size(); ++k) {
    if (f.value[k] > 0.0) continue;
    if (f.input[k] > 0.0) {
      within.upper = root(k);
      break;
    }
    within.lower = just_above(root(k + 1));
  }
  return within;
}

}  // namespace

Characteristic::Characteristic(Table table) : form_(std::move(table)) {
  const Table& t = std::get<Table>(form_);
  if (t.input.empty() || t.input.size() != t.value.size())
    throw std::invalid_argument("a table needs one value for each input, and at least one input");
  if (std::adjacent_find(t.input.begin(), t.input.end(), std::greater_equal<>()) != t.input.end())
    throw std::invalid_argument("the inputs of a table must increase from value to value");
}

double Characteristic::operator()(double input) const {
  return std::visit([&](const auto& form) { return at(form, input); }, form_);
}

Interval Characteristic::positive_within() const {
  return std::visit([](const auto& form) { return correction::positive_within(form); }, form_);
}

}  // namespace raceway::correction
