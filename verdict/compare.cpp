#include "verdict/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

#include "fit/distributions.h"
#include "fit/separable.h"
#include "record/levels.h"
#include "record/repeats.h"
#include "verdict/estimated_noise.h"
#include "verdict/gate.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

constexpr std::size_t worst_rows = 5;
constexpr std::size_t most_levels = 12;  // of an input; more are binned
constexpr std::size_t most_bins = 8;
constexpr std::size_t fewest_per_bin = 5;
constexpr int fewest_pairs = 8;
constexpr double string_ratio = 0.02, string_difference = 2.0;  // settings within make one string

ErrorRange error_range(const record::Channel& channel, const std::vector<RowError>& errors,
                       const std::vector<std::size_t>& members, const record::Record& record) {
  ErrorRange range{.channel = &channel};
  range.rows = static_cast<int>(members.size());
  double square = 0.0, sum = 0.0;
  range.from = std::numeric_limits<double>::infinity();
  range.to = -range.from;
  for (const std::size_t m : members) {
    const double value = record.value(channel, errors[m].row);
    range.from = std::min(range.from, value);
    range.to = std::max(range.to, value);
    square += errors[m].residual * errors[m].residual;
    sum += errors[m].residual;
  }
  const auto count = static_cast<double>(members.size());
  range.rmse = std::sqrt(square / count);
  range.bias = sum / count;
  if (range.is_run() && range.from >= 0.0)
    range.run = record.runs.at(static_cast<std::size_t>(range.from));
  if (channel.role == record::Role::part)
    range.run = record.parts.at(static_cast<std::size_t>(range.from)).name;
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

void add_ranges(const record::Channel& channel, const record::Record& record, Comparison& result) {
  const std::span<const double> column = record.values(channel);
  const auto value = [&](std::size_t m) { return column[result.errors[m].row]; };
  std::vector<std::size_t> order(result.errors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t m) { return std::isnan(value(m)); });
  if (order.empty()) return;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
  const double ends[] = {value(order.front()), value(order.back())};
  const double resolution = record::step_of(channel, ends);
  if (!(ends[1] - ends[0] > resolution)) return;
  std::vector<std::vector<std::size_t>> parts = levels(order, value, resolution);
  // A dense sweep has no steps or too many; a level must also be narrow against the whole range.
  const bool narrow = std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
    return value(part.back()) - value(part.front()) <= 0.1 * (ends[1] - ends[0]);
  });
  if (channel.role != record::Role::run && (parts.size() > most_levels || !narrow))
    parts = quantile_bins(order, value);
  if (parts.size() < 2) return;
  for (const std::vector<std::size_t>& part : parts)
    result.where.push_back(error_range(channel, result.errors, part, record));
}

void add_records(const record::Record& record, Comparison& result) {
  for (std::size_t k = 0; k < record.parts.size(); ++k) {
    std::vector<std::size_t> members;
    for (std::size_t m = 0; m < result.errors.size(); ++m)
      if (record.part_of(result.errors[m].row) == k) members.push_back(m);
    if (!members.empty())
      result.records.push_back(error_range(record::part, result.errors, members, record));
  }
}

/// What rows are strung along: the first setting on a ratio scale, otherwise time.
const record::Column* swept(const record::Record& record) {
  for (const record::Column& c : record.columns)
    if (c.channel->role == record::Role::setting && c.channel->ratio) return &c;
  return record.find(record::time);
}

Pattern find_pattern(const record::Record& record, const std::vector<RowError>& errors) {
  Pattern pattern;
  const record::Column* const along = swept(record);
  if (!along) return pattern;
  pattern.along = along->channel;
  std::vector<const record::Column*> others;
  for (const record::Column& c : record.columns)
    if (&c != along && c.channel->role == record::Role::setting) others.push_back(&c);
  const auto key = [&](const RowError& e) {
    std::vector<long> steps{record.run_of(e.row), static_cast<long>(record.part_of(e.row))};
    for (const record::Column* c : others) {
      const double v = c->values[e.row];
      steps.push_back(std::isnan(v)        ? std::numeric_limits<long>::max()
                      : !c->channel->ratio ? std::lround(v / string_difference)
                      : std::abs(v) > 0.0  ? std::lround(std::log(std::abs(v)) / string_ratio)
                                           : std::numeric_limits<long>::min());
    }
    return steps;
  };
  std::map<std::vector<long>, std::vector<const RowError*>> strings;
  double square = 0.0;
  for (const RowError& e : errors) {
    strings[key(e)].push_back(&e);
    square += e.residual * e.residual;
  }
  square /= static_cast<double>(errors.size());
  double product = 0.0;
  for (auto& [_, string] : strings) {
    std::stable_sort(string.begin(), string.end(), [&](const RowError* a, const RowError* b) {
      return along->values[a->row] < along->values[b->row];
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

/// χ² against the standard deviations of the rows.
LackOfFit test_against_deviations(const Comparison& comparison, int fitted_parameters) {
  LackOfFit test;
  double chi_square = 0.0;
  for (const RowError& e : comparison.errors) chi_square += e.sigmas * e.sigmas;
  test.degrees_of_freedom = comparison.rows - fitted_parameters;
  if (test.degrees_of_freedom < 1) return test;
  test.statistic = chi_square / test.degrees_of_freedom;
  test.p_value = fit::chi_squared_above(test.degrees_of_freedom, chi_square);
  return test;
}

/// F against the scatter within repeats.
LackOfFit test_against_repeats(const record::Record& record, const Comparison& comparison,
                               int fitted_parameters) {
  LackOfFit test;
  std::vector<double> residual(record.rows(), unset);
  std::vector<std::size_t> rows;
  double total = 0.0;
  for (const RowError& e : comparison.errors) {
    residual[e.row] = e.residual;
    rows.push_back(e.row);
    total += e.residual * e.residual;
  }
  // Pure error from residuals, not readings: what the model says of the small differences of
  // operating point within a group is taken out.
  double pure = 0.0;
  int degrees = 0;
  for (const record::RepeatGroup& group : record::find_repeats(record, {}, rows)) {
    double sum = 0.0, square = 0.0;
    for (const std::size_t i : group) {
      sum += residual[i];
      square += residual[i] * residual[i];
    }
    const auto count = static_cast<double>(group.size());
    pure += std::max(0.0, square - sum * sum / count);
    degrees += static_cast<int>(group.size()) - 1;
  }
  test.noise_degrees_of_freedom = degrees;
  test.degrees_of_freedom = comparison.rows - degrees - fitted_parameters;
  if (degrees < 1 || test.degrees_of_freedom < 1 || !(pure > 0.0)) return test;
  test.statistic = ((total - pure) / test.degrees_of_freedom) / (pure / degrees);
  test.p_value = fit::f_above(test.degrees_of_freedom, degrees, std::max(0.0, test.statistic));
  return test;
}

LackOfFit test_lack_of_fit(const record::Record& record, const Comparison& comparison,
                           int fitted_parameters) {
  switch (comparison.noise.source) {
    case fit::NoiseSource::none:
      return {};
    case fit::NoiseSource::repeats:
      return test_against_repeats(record, comparison, fitted_parameters);
    default:
      return test_against_deviations(comparison, fitted_parameters);
  }
}

/// Four digits, and of larger numbers all before the point: 785.5, 14974.
std::string range_end(double value) {
  const double size = std::abs(value);
  return size < 1e4 || size >= 1e9 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

std::string where_text(const ErrorRange& range) {
  if (range.is_run())
    return range.run.empty() ? "in rows without run_id"
                             : fmt::format("in {} {}", range.channel->words, range.run);
  const record::Channel& of = *range.channel;
  const std::string from = range_end(of.in_unit(range.from));
  const std::string to = range_end(of.in_unit(range.to));
  const std::string place = !of.place.empty() ? std::string(of.place)
                            : of.unit == "1"  ? fmt::format("of {}", of.words)
                                              : fmt::format("{} of {}", of.unit, of.words);
  return from == to ? fmt::format("at {} {}", from, place)
                    : fmt::format("at {} to {} {}", from, to, place);
}

/// What a tolerance says of the misfit; empty where there is none.
std::string tolerance_text(const Comparison& c) {
  if (std::isnan(c.tolerance)) return {};
  return fmt::format(" The RMS misfit {} the tolerance of {:.3g} {}.",
                     c.rmse <= c.tolerance ? "is within" : "exceeds",
                     c.tolerance / c.channel->factor, unit_of_difference(*c.channel));
}

std::string statement_of(const Comparison& c) {
  const record::Channel& q = *c.channel;
  const std::string misfit = fmt::format("The RMS misfit ({:.3g} {})", c.rmse / q.factor, q.unit);
  const LackOfFit& test = c.lack_of_fit;
  const std::string noise = fmt::format("{:.2g} {}", c.noise.rms / q.factor, q.unit);
  const std::string statistic =
      fmt::format("{} = {:.3g}, {}", c.noise.source == fit::NoiseSource::repeats ? "F" : "chi2/dof",
                  test.statistic, p_value_text(test.p_value));
  // A place is worse than the rest only if it errs clearly more than the average.
  const std::string place = !c.where.empty() && c.where.front().rmse > 1.2 * c.rmse
                                ? "; the misfit is largest " + where_text(c.where.front())
                                : "";
  const bool tested = std::isfinite(test.p_value);
  if (c.judgement == Judgement::structure && tested)
    return fmt::format("{} is systematic, not noise ({}): {}{}.", misfit, noise, statistic, place);
  if (c.judgement == Judgement::noise)
    return fmt::format("{} agrees with the noise ({}): {}.", misfit, noise, statistic);
  const std::string why =
      "the noise of these data is not known (too few repeated rows, and not every row has a "
      "standard deviation)";
  if (c.judgement == Judgement::structure)
    return fmt::format(
        "{} is systematic at least in part: readings that are neighbours in {} have similar "
        "residuals (correlation "
        "{:.2f}, {}), but {}{}.",
        misfit, c.pattern.along->words, c.pattern.correlation, p_value_text(c.pattern.p_value), why,
        place);
  if (std::isfinite(c.pattern.p_value))
    return fmt::format(
        "{} shows no clear pattern over {} (correlation {:.2f}, {}; a pattern needs p < {:g}), but "
        "{}{}.",
        misfit, c.pattern.along->words, c.pattern.correlation, p_value_text(c.pattern.p_value),
        alarm_level, why, place);
  return fmt::format("{} cannot be judged: {}{}.", misfit, why, place);
}

void find_errors(std::span<const double> predicted, const record::Record& record,
                 Comparison& result) {
  const std::span<const double> readings = record.values(*result.channel);
  const record::Column* const deviation = record.deviation_of(*result.channel);
  const bool by_row = deviation && (result.noise.source == fit::NoiseSource::declared ||
                                    result.noise.source == fit::NoiseSource::regression);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isnan(readings[i])) continue;  // not read then
    const double residual = predicted[i] - readings[i];
    if (!std::isfinite(residual)) {
      result.rows_not_predicted.push_back(i);
      continue;
    }
    const double std = by_row ? deviation->values[i] : result.noise.rms;
    result.errors.push_back({.row = i,
                             .line = record.line(i),
                             .predicted = predicted[i],
                             .measured = readings[i],
                             .residual = residual,
                             .std = std,
                             .sigmas = residual / std});
  }
}

void sum_up(Comparison& result) {
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
}

Judgement judged_by_tolerance(const Comparison& c) {
  if (std::isnan(c.tolerance)) return Judgement::unknown;
  return c.rmse <= c.tolerance ? Judgement::noise : Judgement::structure;
}

/// Of a model that only comes near.
std::string statement_beside(const Comparison& c) {
  const record::Channel& q = *c.channel;
  std::string text =
      fmt::format("The RMS misfit is {:.3g} {}", c.rmse / q.factor, unit_of_difference(q));
  if (std::isfinite(c.noise.rms) && c.noise.rms > 0.0)
    text += fmt::format(", {:.2g} times the noise of a reading", c.rmse / c.noise.rms);
  if (!c.where.empty() && c.where.front().rmse > 1.2 * c.rmse)
    text += "; the misfit is largest " + where_text(c.where.front());
  return text + ".";
}

/// As approximations have it: a sum over the correlation until it is lost, of means of what is left
/// over equal times.
double correlation_time(const record::Record& record, const std::vector<RowError>& errors) {
  constexpr std::size_t pieces = 2000;
  constexpr double lost = 0.05;
  const std::span<const double> time = record.values(record::time);
  if (time.empty() || errors.size() < 8) return unset;
  const std::size_t count = std::min(pieces, errors.size());
  std::vector<double> left;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t begin = k * errors.size() / count, end = (k + 1) * errors.size() / count;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += errors[i].residual;
    left.push_back(sum / static_cast<double>(end - begin));
  }
  const auto product = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < left.size(); ++i) sum += left[i] * left[i - lag];
    return sum;
  };
  const double square = product(0);
  double sum = 0.0;
  for (std::size_t lag = 1; lag < left.size() / 2 && square > 0.0; ++lag) {
    const double rho = product(lag) / square;
    if (rho < lost) break;
    sum += rho;
  }
  return sum * (time[errors.back().row] - time[errors.front().row]) /
         static_cast<double>(count - 1);
}

}  // namespace

fit::Noise noise_of(const record::Record& record, const fit::Measured& measured) {
  if (!measured.approximate) return fit::estimate_noise(record, *measured.channel);
  if (std::isfinite(measured.std))
    return {.rms = measured.std, .source = fit::NoiseSource::declared};
  const double rms = fit::noise_of_neighbours(record, *measured.channel);
  return {.rms = rms,
          .source = std::isfinite(rms) ? fit::NoiseSource::neighbours : fit::NoiseSource::none};
}

std::string p_value_text(double p) {
  return p < 1e-300 ? "p < 1e-300"
         : p < 1e-3 ? fmt::format("p = {:.0e}", p)
                    : fmt::format("p = {:.2g}", p);
}

Comparison compare(std::span<const double> predicted, const record::Record& record,
                   const fit::Measured& measured, int fitted_parameters) {
  if (predicted.size() != record.rows())
    throw std::invalid_argument("compare: give one prediction for each row");
  if (record.rows() == 0) throw std::invalid_argument(record.source + ": the record has no rows");
  Comparison result{.channel = measured.channel};
  result.tolerance = fit::tolerance_of(measured, record);
  result.begins = measured.begins;
  result.noise = noise_of(record, measured);
  find_errors(predicted, record, result);
  if (result.errors.empty())
    throw std::invalid_argument(record.source + ": the model predicts none of the rows");
  sum_up(result);
  if (!measured.approximate) {
    result.lack_of_fit = test_lack_of_fit(record, result, fitted_parameters);
    result.pattern = find_pattern(record, result.errors);
  } else {
    result.judgement = judged_by_tolerance(result);
    result.correlation_time = correlation_time(record, result.errors);
  }
  if (std::isfinite(result.lack_of_fit.p_value))
    result.judgement =
        result.lack_of_fit.p_value < alarm_level ? Judgement::structure : Judgement::noise;
  else if (result.pattern.p_value < alarm_level)
    result.judgement = Judgement::structure;
  // Runs that are records are told as these.
  const bool runs = record.parts.empty() || record.runs.size() > record.parts.size();
  for (const record::Column& c : record.columns)
    if (c.channel->is_input() || (measured.approximate && c.channel->role == record::Role::time) ||
        (runs && *c.channel == record::run))
      add_ranges(*c.channel, record, result);
  add_records(record, result);
  std::stable_sort(result.where.begin(), result.where.end(),
                   [](const ErrorRange& a, const ErrorRange& b) { return a.rmse > b.rmse; });
  result.worst = result.errors;
  std::stable_sort(result.worst.begin(), result.worst.end(),
                   [](const RowError& a, const RowError& b) {
                     return std::abs(a.residual) > std::abs(b.residual);
                   });
  result.worst.resize(std::min(worst_rows, result.worst.size()));
  result.statement = (measured.approximate ? statement_beside(result) : statement_of(result)) +
                     tolerance_text(result);
  return result;
}

std::vector<Comparison> compare(const fit::Subject& subject, const record::Record& record,
                                int fitted_parameters) {
  subject.require(record);
  const std::vector<double> predicted = fit::predict(subject, record);
  const std::vector<fit::Measured> channels = subject.measured();
  std::vector<Comparison> result;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (record.has(*channels[c].channel))
      result.push_back(compare(std::span(predicted).subspan(c * record.rows(), record.rows()),
                               record, channels[c], fitted_parameters));
  return result;
}

void add_groups(Comparison& comparison, const record::Channel& kind,
                const std::vector<std::string>& group) {
  std::map<std::string, ErrorRange> ranges;
  for (const RowError& e : comparison.errors) {
    if (group[e.row].empty()) continue;
    ErrorRange& range = ranges[group[e.row]];
    range.channel = &kind;
    range.run = group[e.row];
    if (range.rows++ == 0) range.rmse = range.bias = 0.0;
    range.rmse += e.residual * e.residual;
    range.bias += e.residual;
  }
  for (auto& [_, range] : ranges) {
    range.rmse = std::sqrt(range.rmse / range.rows);
    range.bias /= range.rows;
    comparison.where.push_back(range);
  }
  std::stable_sort(comparison.where.begin(), comparison.where.end(),
                   [](const ErrorRange& a, const ErrorRange& b) { return a.rmse > b.rmse; });
}

void estimate_unknown_noise(const fit::Subject& subject, const record::Record& record,
                            std::vector<Comparison>& comparisons) {
  const auto unknown = [](const Comparison& c) { return c.noise.source == fit::NoiseSource::none; };
  if (std::none_of(comparisons.begin(), comparisons.end(), unknown)) return;
  // Of what only comes near a diagnosis knows no noise; readings at stops bound it.
  for (const fit::Measured& m : subject.measured())
    for (Comparison& c : comparisons)
      if (m.approximate && unknown(c) && *c.channel == *m.channel)
        c.estimated_noise = fit::noise_of_calm_readings(record, *m.channel);
  const auto estimated = estimate_noise_as_diagnosis(subject, record);
  if (!estimated) return;
  for (const EstimatedNoise& noise : *estimated)
    for (Comparison& c : comparisons) {
      if (!unknown(c) || !(*c.channel == *noise.channel)) continue;
      c.estimated_noise = noise.rms;
      for (RowError& e : c.errors) e.std = noise.std[e.row];
    }
}

}  // namespace raceway::verdict
