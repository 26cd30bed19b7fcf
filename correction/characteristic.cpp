#include "correction/characteristic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace raceway::correction {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

double at(const Characteristic::Line& f, double P) { return f.slope * P + f.offset; }
double at(const Characteristic::Power& f, double P) { return f.factor * std::pow(P, f.exponent); }
double at(const Characteristic::Table& f, double P) {
  const auto after = std::upper_bound(f.power.begin(), f.power.end(), P);
  if (after == f.power.begin()) return f.value.front();
  if (after == f.power.end()) return f.value.back();
  const auto k = static_cast<std::size_t>(after - f.power.begin());
  const double share = (P - f.power[k - 1]) / (f.power[k] - f.power[k - 1]);
  return f.value[k - 1] + share * (f.value[k] - f.value[k - 1]);
}

double positive_below(const Characteristic::Line& f) {
  if (f.offset <= 0.0) return 0.0;
  return f.slope < 0.0 ? -f.offset / f.slope : nowhere;
}
double positive_below(const Characteristic::Power& f) { return f.factor > 0.0 ? nowhere : 0.0; }
double positive_below(const Characteristic::Table& f) {
  if (f.value.front() <= 0.0) return 0.0;
  for (std::size_t k = 1; k < f.value.size(); ++k)
    if (f.value[k] <= 0.0)
      return f.power[k - 1] +
             (f.power[k] - f.power[k - 1]) * f.value[k - 1] / (f.value[k - 1] - f.value[k]);
  return nowhere;
}

}  // namespace

Characteristic::Characteristic(Table table) : form_(std::move(table)) {
  const Table& t = std::get<Table>(form_);
  if (t.power.empty() || t.power.size() != t.value.size())
    throw std::invalid_argument("a table needs a value for each of its powers");
  if (std::adjacent_find(t.power.begin(), t.power.end(), std::greater_equal<>()) != t.power.end())
    throw std::invalid_argument("the powers of a table must rise");
}

double Characteristic::operator()(double power) const {
  return std::visit([&](const auto& form) { return at(form, power); }, form_);
}

double Characteristic::positive_below() const {
  return std::visit([](const auto& form) { return correction::positive_below(form); }, form_);
}

}  // namespace raceway::correction
