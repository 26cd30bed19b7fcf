#include "fit/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

#include "fit/quantity.h"
#include "fit/shaft_prediction.h"
#include "fit/shaft_response.h"

namespace raceway::fit {

namespace {

constexpr double alarm_level = 0.01;
constexpr std::size_t worst_rows = 5;
constexpr std::size_t most_levels = 12;  // of a variable; more are binned
constexpr std::size_t most_bins = 8;
constexpr std::size_t fewest_per_bin = 5;
constexpr int fewest_pairs = 8;

/// Below this, differences are scatter of a set value, not a variation.
double resolution_of(Variable variable, double largest) {
  if (variable == Variable::run) return 0.5;
  return variable == Variable::temperature ? 0.5 : 0.005 * largest;
}

ErrorRange error_range(Variable variable, const std::vector<RowError>& errors,
                       const std::vector<std::size_t>& members, const DataSet& data) {
  ErrorRange range;
  range.variable = variable;
  range.rows = static_cast<int>(members.size());
  double square = 0.0, sum = 0.0;
  range.from = std::numeric_limits<double>::infinity();
  range.to = -range.from;
  for (const std::size_t m : members) {
    const double value = value_of(variable, data.rows[errors[m].row]);
    range.from = std::min(range.from, value);
    range.to = std::max(range.to, value);
    square += errors[m].residual * errors[m].residual;
    sum += errors[m].residual;
  }
  const auto count = static_cast<double>(members.size());
  range.rmse = std::sqrt(square / count);
  range.bias = sum / count;
  if (variable == Variable::run && range.from >= 0.0)
    range.run = data.runs.at(static_cast<std::size_t>(range.from));
  return range;
}

/// Sorted members cut into levels: a new one where the value steps by more than the resolution.
std::vector<std::vector<std::size_t>> levels(const std::vector<std::size_t>& order,
                                             const std::function<double(std::size_t)>& value,
                                             double resolution) {
  std::vector<std::vector<std::size_t>> result;
  for (const std::size_t m : order) {
    if (result.empty() || value(m) - value(result.back().back()) > resolution)
      result.emplace_back();
    result.back().push_back(m);
  }
  return result;
}

/// Bins of about equally many members; equal values stay together.
std::vector<std::vector<std::size_t>> quantile_bins(
    const std::vector<std::size_t>& order, const std::function<double(std::size_t)>& value) {
  const std::size_t bins = std::clamp<std::size_t>(order.size() / fewest_per_bin, 1, most_bins);
  std::vector<std::vector<std::size_t>> result(1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool full = i >= result.size() * order.size() / bins;
    if (full && i > 0 && value(order[i]) > value(order[i - 1])) result.emplace_back();
    result.back().push_back(order[i]);
  }
  return result;
}

void add_ranges(Variable variable, const DataSet& data, Comparison& result) {
  const auto value = [&](std::size_t m) {
    return value_of(variable, data.rows[result.errors[m].row]);
  };
  std::vector<std::size_t> order(result.errors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t m) { return std::isnan(value(m)); });
  if (order.empty()) return;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
  const double lowest = value(order.front()), highest = value(order.back());
  const double resolution = resolution_of(variable, std::max(std::abs(lowest), std::abs(highest)));
  if (!(highest - lowest > resolution)) return;
  std::vector<std::vector<std::size_t>> parts = levels(order, value, resolution);
  // A dense sweep has no steps or too many; a level must also be narrow against the whole range.
  const bool narrow = std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
    return value(part.back()) - value(part.front()) <= 0.1 * (highest - lowest);
  });
  if (variable != Variable::run && (parts.size() > most_levels || !narrow))
    parts = quantile_bins(order, value);
  if (parts.size() < 2) return;
  for (const std::vector<std::size_t>& part : parts)
    result.where.push_back(error_range(variable, result.errors, part, data));
}

Pattern find_pattern(const DataSet& data, const std::vector<RowError>& errors) {
  // Loads within 2 % and temperatures within 2 K make one string.
  const bool displaced = data.quantity == Quantity::axial_displacement;
  const auto key = [&](const RowError& e) {
    const Row& row = data.rows[e.row];
    const auto step = [](double load) {
      return load > 0.0 ? std::lround(std::log(load) / 0.02) : std::numeric_limits<long>::min();
    };
    return std::tuple{row.run, step(std::abs(row.point.axial_load)),
                      step(value_of(Variable::radial_load, row)),
                      std::lround(row.point.temperature / 2.0), displaced ? step(row.preload) : 0};
  };
  std::map<decltype(key(errors.front())), std::vector<const RowError*>> strings;
  double square = 0.0;
  for (const RowError& e : errors) {
    strings[key(e)].push_back(&e);
    square += e.residual * e.residual;
  }
  square /= static_cast<double>(errors.size());
  Pattern pattern;
  double product = 0.0;
  for (auto& [_, string] : strings) {
    std::stable_sort(string.begin(), string.end(), [&](const RowError* a, const RowError* b) {
      return data.rows[a->row].point.speed < data.rows[b->row].point.speed;
    });
    for (std::size_t i = 1; i < string.size(); ++i) {
      product += string[i - 1]->residual * string[i]->residual;
      ++pattern.pairs;
    }
  }
  if (pattern.pairs < fewest_pairs || !(square > 0.0)) return pattern;
  pattern.correlation = std::clamp(product / (square * pattern.pairs), -1.0, 1.0);
  pattern.p_value = 0.5 * std::erfc(pattern.correlation * std::sqrt(pattern.pairs / 2.0));
  return pattern;
}

/// χ² against declared noise, F against the scatter within repeats.
LackOfFit test_lack_of_fit(const DataSet& data, const Comparison& comparison,
                           int fitted_parameters) {
  namespace math = boost::math;
  LackOfFit test;
  const NoiseSource source = comparison.noise.source;
  if (source == NoiseSource::none) return test;
  if (source != NoiseSource::repeats) {
    double chi_square = 0.0;
    for (const RowError& e : comparison.errors) chi_square += e.sigmas * e.sigmas;
    test.degrees_of_freedom = comparison.rows - fitted_parameters;
    if (test.degrees_of_freedom < 1) return test;
    test.statistic = chi_square / test.degrees_of_freedom;
    test.p_value =
        math::cdf(math::complement(math::chi_squared(test.degrees_of_freedom), chi_square));
    return test;
  }
  std::vector<double> residual(data.rows.size(), unset);
  double total = 0.0;
  for (const RowError& e : comparison.errors) {
    residual[e.row] = e.residual;
    total += e.residual * e.residual;
  }
  // Pure error from residuals, not readings: what the model says of the small differences of
  // operating point within a group is taken out.
  double pure = 0.0;
  int degrees = 0;
  for (const RepeatGroup& group : find_repeats(data)) {
    double sum = 0.0, square = 0.0;
    int count = 0;
    for (const std::size_t i : group) {
      if (std::isnan(residual[i])) continue;
      sum += residual[i];
      square += residual[i] * residual[i];
      ++count;
    }
    if (count < 2) continue;
    pure += std::max(0.0, square - sum * sum / count);
    degrees += count - 1;
  }
  test.noise_degrees_of_freedom = degrees;
  test.degrees_of_freedom = comparison.rows - degrees - fitted_parameters;
  if (degrees < 1 || test.degrees_of_freedom < 1 || !(pure > 0.0)) return test;
  test.statistic = ((total - pure) / test.degrees_of_freedom) / (pure / degrees);
  test.p_value = math::cdf(math::complement(math::fisher_f(test.degrees_of_freedom, degrees),
                                            std::max(0.0, test.statistic)));
  return test;
}

std::string p_text(double p) {
  return p < 1e-300 ? "p < 1e-300"
         : p < 1e-3 ? fmt::format("p = {:.0e}", p)
                    : fmt::format("p = {:.2g}", p);
}

std::string where_text(const ErrorRange& range) {
  double unit = 1.0, offset = 0.0;
  std::string unit_name;
  switch (range.variable) {
    case Variable::speed:
      unit = rpm, unit_name = "rpm";
      break;
    case Variable::axial_load:
      unit_name = "N axial load";
      break;
    case Variable::radial_load:
      unit_name = "N radial load";
      break;
    case Variable::preload:
      unit_name = "N preload";
      break;
    case Variable::temperature:
      offset = celsius_zero, unit_name = "C";
      break;
    case Variable::run:
      return range.run.empty() ? "in rows without run_id" : "in run " + range.run;
  }
  const std::string from = fmt::format("{:.4g}", (range.from - offset) / unit);
  const std::string to = fmt::format("{:.4g}", (range.to - offset) / unit);
  return from == to ? fmt::format("at {} {}", from, unit_name)
                    : fmt::format("at {} to {} {}", from, to, unit_name);
}

std::string statement_of(const Comparison& c) {
  const QuantityText q = text_of(c.quantity);
  const std::string misfit = fmt::format("The misfit ({:.3g} {})", c.rmse / q.factor, q.unit);
  const LackOfFit& test = c.lack_of_fit;
  const std::string noise = fmt::format("{:.2g} {}", c.noise.rms / q.factor, q.unit);
  const std::string statistic =
      fmt::format("{} = {:.3g}, {}", c.noise.source == NoiseSource::repeats ? "F" : "chi2/dof",
                  test.statistic, p_text(test.p_value));
  // A place is worse than the rest only if it errs clearly more than the average.
  const std::string place = !c.where.empty() && c.where.front().rmse > 1.2 * c.rmse
                                ? "; it is worst " + where_text(c.where.front())
                                : "";
  const bool tested = std::isfinite(test.p_value);
  if (c.judgement == Judgement::structure && tested)
    return fmt::format("{} is structure, not noise ({}): {}{}.", misfit, noise, statistic, place);
  if (c.judgement == Judgement::noise)
    return fmt::format("{} is no larger than the noise ({}) explains: {}.", misfit, noise,
                       statistic);
  const std::string why =
      "the noise of these data is not known (no repeated rows, no declared std)";
  if (c.judgement == Judgement::structure)
    return fmt::format(
        "{} is structure at least in part: neighbours in speed err alike "
        "(correlation {:.2f}, {}), while {}{}.",
        misfit, c.pattern.correlation, p_text(c.pattern.p_value), why, place);
  if (std::isfinite(c.pattern.p_value))
    return fmt::format("{} shows no pattern over speed (correlation {:.2f}, {}), but {}{}.", misfit,
                       c.pattern.correlation, p_text(c.pattern.p_value), why, place);
  return fmt::format("{} cannot be judged: {}{}.", misfit, why, place);
}

}  // namespace

std::string_view name(Variable variable) {
  switch (variable) {
    case Variable::speed:
      return "speed";
    case Variable::axial_load:
      return "axial_load";
    case Variable::radial_load:
      return "radial_load";
    case Variable::temperature:
      return "temperature";
    case Variable::run:
      return "run";
    case Variable::preload:
      return "preload";
  }
  return "unknown";
}

double value_of(Variable variable, const Row& row) {
  switch (variable) {
    case Variable::speed:
      return row.point.speed;
    case Variable::axial_load:
      return row.point.axial_load;
    case Variable::radial_load:
      return std::hypot(row.point.radial_load, row.point.radial_load_z);
    case Variable::temperature:
      return row.point.temperature;
    case Variable::run:
      return row.run;
    case Variable::preload:
      return row.preload;
  }
  return unset;
}

Comparison compare(const std::vector<double>& predicted, const DataSet& data,
                   int fitted_parameters) {
  if (predicted.size() != data.rows.size())
    throw std::invalid_argument("compare: one prediction per row is needed");
  if (data.rows.empty()) throw std::invalid_argument(data.source + ": no rows to compare with");

  Comparison result;
  result.quantity = data.quantity;
  result.noise = estimate_noise(data);
  const bool by_row = result.noise.source == NoiseSource::declared ||
                      result.noise.source == NoiseSource::regression;
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const Row& row = data.rows[i];
    const double residual = predicted[i] - row.measured;
    if (!std::isfinite(residual)) {
      result.rows_not_predicted.push_back(row.line);
      continue;
    }
    result.errors.push_back({.row = i,
                             .line = row.line,
                             .predicted = predicted[i],
                             .measured = row.measured,
                             .residual = residual,
                             .sigmas = residual / (by_row ? row.std : result.noise.rms)});
  }
  if (result.errors.empty())
    throw std::invalid_argument(data.source + ": the model predicts none of the rows");

  result.rows = static_cast<int>(result.errors.size());
  const auto count = static_cast<double>(result.rows);
  double sum = 0.0, magnitude = 0.0, square = 0.0, mean = 0.0, reading_square = 0.0;
  result.max_abs = 0.0;
  for (const RowError& e : result.errors) {
    sum += e.residual;
    magnitude += std::abs(e.residual);
    square += e.residual * e.residual;
    mean += e.measured / count;
    reading_square += e.measured * e.measured;
    result.max_abs = std::max(result.max_abs, std::abs(e.residual));
  }
  double spread = 0.0;
  for (const RowError& e : result.errors) spread += (e.measured - mean) * (e.measured - mean);
  result.bias = sum / count;
  result.mae = magnitude / count;
  result.rmse = std::sqrt(square / count);
  if (spread > 1e-24 * reading_square)  // more than the rounding of equal readings
    result.fit_percent = 100.0 * (1.0 - std::sqrt(square / spread));

  result.lack_of_fit = test_lack_of_fit(data, result, fitted_parameters);
  result.pattern = find_pattern(data, result.errors);
  if (std::isfinite(result.lack_of_fit.p_value))
    result.judgement =
        result.lack_of_fit.p_value < alarm_level ? Judgement::structure : Judgement::noise;
  else if (result.pattern.p_value < alarm_level)
    result.judgement = Judgement::structure;

  for (const Variable variable : {Variable::speed, Variable::axial_load, Variable::radial_load,
                                  Variable::temperature, Variable::run})
    add_ranges(variable, data, result);
  if (data.quantity == Quantity::axial_displacement) add_ranges(Variable::preload, data, result);
  std::stable_sort(result.where.begin(), result.where.end(),
                   [](const ErrorRange& a, const ErrorRange& b) { return a.rmse > b.rmse; });
  result.worst = result.errors;
  std::stable_sort(result.worst.begin(), result.worst.end(),
                   [](const RowError& a, const RowError& b) {
                     return std::abs(a.residual) > std::abs(b.residual);
                   });
  result.worst.resize(std::min(worst_rows, result.worst.size()));
  result.statement = statement_of(result);
  return result;
}

Comparison compare(const Model& model, const DataSet& data, int fitted_parameters) {
  return compare(predict_readings(model, data), data, fitted_parameters);
}

}  // namespace raceway::fit
