#include "fit/misfit_map.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>

namespace raceway::fit {
namespace {

constexpr double chance = 0.05;  // of any significant cell where nothing is wrong

std::vector<ErrorRange> ranges_of(const Comparison& comparison, Variable variable) {
  std::vector<ErrorRange> ranges;
  for (const ErrorRange& r : comparison.where)
    if (r.variable == variable) ranges.push_back(r);
  std::sort(ranges.begin(), ranges.end(),
            [](const ErrorRange& a, const ErrorRange& b) { return a.from < b.from; });
  return ranges;
}

/// One range that holds every row.
ErrorRange all_rows(const Comparison& comparison, const DataSet& data, Variable variable) {
  ErrorRange range{.variable = variable, .run = {}, .rows = comparison.rows};
  range.from = std::numeric_limits<double>::infinity();
  range.to = -range.from;
  for (const RowError& e : comparison.errors) {
    const double value = value_of(variable, data.rows[e.row]);
    range.from = std::min(range.from, value);
    range.to = std::max(range.to, value);
  }
  range.rmse = comparison.rmse;
  range.bias = comparison.bias;
  return range;
}

/// The last range that begins at or below the value: ranges do not overlap and hold every row.
std::size_t place(const std::vector<ErrorRange>& ranges, double value) {
  const auto above =
      std::upper_bound(ranges.begin(), ranges.end(), value,
                       [](double v, const ErrorRange& range) { return v < range.from; });
  return static_cast<std::size_t>(above - ranges.begin()) - 1;
}

}  // namespace

MisfitMap misfit_map(const Comparison& comparison, const DataSet& data,
                     std::span<const double> std) {
  MisfitMap map;
  map.across = ranges_of(comparison, Variable::speed);
  if (map.across.empty()) map.across = {all_rows(comparison, data, Variable::speed)};
  for (const Variable variable : {Variable::axial_load, Variable::radial_load, Variable::preload,
                                  Variable::temperature, Variable::run}) {
    map.up = ranges_of(comparison, variable);
    map.up_variable = variable;
    if (!map.up.empty()) break;
  }
  if (map.up.empty()) {
    map.up_variable = Variable::axial_load;
    map.up = {all_rows(comparison, data, Variable::axial_load)};
  }
  struct Sum {
    int rows = 0;
    double residual = 0.0, variance = 0.0;
  };
  std::vector<Sum> sums(map.across.size() * map.up.size());
  for (std::size_t i = 0; i < comparison.errors.size(); ++i) {
    const RowError& e = comparison.errors[i];
    const Row& row = data.rows[e.row];
    const std::size_t x = place(map.across, value_of(Variable::speed, row));
    const std::size_t y = place(map.up, value_of(map.up_variable, row));
    Sum& sum = sums[y * map.across.size() + x];
    ++sum.rows;
    sum.residual += e.residual;
    sum.variance += std[i] * std[i];
  }
  const auto filled = std::count_if(sums.begin(), sums.end(), [](const Sum& s) { return s.rows; });
  map.needed_sigmas = boost::math::quantile(
      boost::math::complement(boost::math::normal(), 0.5 * chance / static_cast<double>(filled)));
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const Sum& sum = sums[k];
    if (sum.rows == 0) continue;
    MisfitCell cell{.across = k % map.across.size(), .up = k / map.across.size(), .rows = sum.rows};
    cell.bias = sum.residual / sum.rows;
    cell.sigmas = sum.residual / std::sqrt(sum.variance);
    cell.significant = std::abs(cell.sigmas) > map.needed_sigmas;
    map.cells.push_back(cell);
  }
  return map;
}

}  // namespace raceway::fit
