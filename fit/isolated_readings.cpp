#include "fit/isolated_readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "record/median.h"

namespace raceway::fit {

namespace {

constexpr std::size_t reach = 2;             // neighbours on either side
constexpr std::size_t longest = 2;           // rows in succession, or
constexpr std::size_t longest_by_model = 3;  // where a model tells them
constexpr double far_away = 6.0;             // robust standard deviations
constexpr double farther = 3.0;              // than the neighbours are from each other
constexpr double finest = 0.003;             // of the range of nine in ten readings
constexpr double steady_speed = 0.01;        // of the largest
constexpr double neighbours = 3.0;           // median steps in time
constexpr double most_isolated = 0.1;        // of the readings
constexpr std::size_t fewest_steady = 30;
constexpr std::size_t most_lines = 20;  // that a statement lists

/// The readings of one channel in the order of their rows, or what a model leaves of them.
class Readings {
 public:
  Readings(const record::Record& record, std::vector<double> values, bool by_model)
      : record_(record), values_(std::move(values)), by_model_(by_model) {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (std::isfinite(values_[i])) rows_.push_back(i);
    std::vector<double> steps;
    for (std::size_t k = 1; k < rows_.size(); ++k) steps.push_back(step(k - 1, k));
    if (!steps.empty()) longest_step_ = neighbours * record::median(steps);
    for (const record::Column& setting : record.columns) {
      if (setting.channel->role != record::Role::setting || !setting.channel->ratio) continue;
      double largest = 0.0;
      for (const double v : setting.values) largest = std::fmax(largest, std::abs(v));
      set_.push_back({&setting, steady_speed * largest});
    }
  }

  [[nodiscard]] std::size_t count() const { return rows_.size(); }
  [[nodiscard]] bool by_model() const { return by_model_; }
  [[nodiscard]] std::size_t row(std::size_t k) const { return rows_[k]; }
  [[nodiscard]] double operator[](std::size_t k) const { return values_[rows_[k]]; }

  /// Whether nothing that is set changes over these readings, unless a model knows what it does,
  /// and none is missing between them.
  [[nodiscard]] bool steady(std::size_t first, std::size_t last) const {
    for (std::size_t k = first; k < last; ++k)
      if (record_.run_of(rows_[k]) != record_.run_of(rows_[k + 1]) ||
          !(step(k, k + 1) <= longest_step_))
        return false;
    return by_model_ || std::all_of(set_.begin(), set_.end(), [&](const auto& of) {
             double low = std::numeric_limits<double>::infinity(), high = -low;
             for (std::size_t row = rows_[first]; row <= rows_[last]; ++row) {
               low = std::fmin(low, of.column->values[row]);
               high = std::fmax(high, of.column->values[row]);
             }
             return high - low <= of.step;
           });
  }

  /// Whether something that is set leaves with these readings and returns.
  [[nodiscard]] bool set_otherwise(std::size_t first, std::size_t last, std::size_t before,
                                   std::size_t after) const {
    return std::any_of(set_.begin(), set_.end(), [&](const auto& of) {
      const std::vector<double>& values = of.column->values;
      for (std::size_t k = first; k <= last; ++k)
        if (std::abs(values[rows_[k]] - values[rows_[before]]) > of.step &&
            std::abs(values[rows_[k]] - values[rows_[after]]) > of.step)
          return true;
      return false;
    });
  }

 private:
  [[nodiscard]] double step(std::size_t a, std::size_t b) const {
    return record_.value(record::time, rows_[b]) - record_.value(record::time, rows_[a]);
  }

  struct Setting {
    const record::Column* column;
    double step;  // that is none [SI]
  };

  const record::Record& record_;
  std::vector<double> values_;
  bool by_model_;
  std::vector<Setting> set_{};
  std::vector<std::size_t> rows_{};
  double longest_step_ = 0.0;
};

/// Which stretches of readings about each reading are steady. A model says what is usual at the
/// ends, too.
std::vector<bool> steady_ones(const Readings& readings) {
  std::vector<bool> steady(readings.count(), false);
  for (std::size_t k = 0; k < readings.count(); ++k) {
    const std::size_t after = std::min(k + reach, readings.count() - 1);
    const bool whole = k >= reach && k + reach < readings.count();
    if (whole || (readings.by_model() && k > 0))
      steady[k] = readings.steady(k < reach ? 0 : k - reach, after);
  }
  return steady;
}

/// The readings in the order of their size; none for too few.
std::vector<double> by_size(const Readings& readings) {
  std::vector<double> all;
  if (readings.count() < fewest_steady) return all;
  for (std::size_t k = 0; k < readings.count(); ++k) all.push_back(readings[k]);
  std::sort(all.begin(), all.end());
  return all;
}

/// That nine in ten readings have.
double usual_range(const std::vector<double>& by_size) {
  return by_size.empty() ? 0.0 : by_size[by_size.size() * 19 / 20] - by_size[by_size.size() / 20];
}

/// That all but a hundredth of the readings at either end have, or but two: a machine that runs now
/// and then for a moment is in it.
double whole_range(const std::vector<double>& by_size) {
  if (by_size.empty()) return 0.0;
  const std::size_t ends = std::max<std::size_t>(2, by_size.size() / 100);
  return by_size[by_size.size() - 1 - ends] - by_size[ends];
}

/// Robust standard deviation of steady readings about the middle of their neighbours; NaN where
/// there are too few.
double scatter_of(const Readings& readings, const std::vector<bool>& steady, double range) {
  std::vector<double> off;
  for (std::size_t k = 0; k < readings.count(); ++k) {
    if (!steady[k] || k < reach || k + reach >= readings.count()) continue;
    std::array around{readings[k - 2], readings[k - 1], readings[k + 1], readings[k + 2]};
    std::sort(around.begin(), around.end());
    off.push_back(std::abs(readings[k] - 0.5 * (around[1] + around[2])));
  }
  if (off.size() < fewest_steady) return unset;
  return std::max(1.4826 * record::median(off), finest * range);
}

/// Whether these readings leave their neighbours by more than `far` and return.
bool leave_and_return(const Readings& readings, std::size_t first, std::size_t last, double before,
                      double after, double far) {
  for (std::size_t k = first; k <= last; ++k) {
    const double one = readings[k] - before, other = readings[k] - after;
    const double least = std::min(std::abs(one), std::abs(other));
    if (!(one * other > 0.0) || !(least > far) || !(least > farther * std::abs(before - after)))
      return false;
  }
  return true;
}

std::string lines_of(const record::Record& record, const std::vector<std::size_t>& rows) {
  std::string lines;
  for (std::size_t k = 0; k < rows.size() && k < most_lines; ++k)
    lines += fmt::format("{}{}", k == 0 ? "" : ", ", record.line(rows[k]));
  if (rows.size() > most_lines) lines += fmt::format(" and {} more", rows.size() - most_lines);
  return lines;
}

/// Rows of readings far beyond all others, at inputs within those of the other rows.
std::vector<std::size_t> far_readings(const record::Record& record,
                                      const record::Channel& channel) {
  constexpr double ranges = 3.0;
  const std::span<const double> values = record.values(channel);
  std::vector<double> sorted;
  for (const double v : values)
    if (std::isfinite(v)) sorted.push_back(v);
  if (sorted.empty()) return {};
  std::sort(sorted.begin(), sorted.end());
  const std::size_t ends = std::max<std::size_t>(2, sorted.size() / 100);
  if (sorted.size() <= 2 * ends) return {};
  const double low = sorted[ends], high = sorted[sorted.size() - 1 - ends],
               far = ranges * (high - low);
  if (!(far > 0.0)) return {};
  std::vector<std::size_t> rows;
  std::vector<bool> is_far(values.size());
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] < low - far || values[row] > high + far) {
      rows.push_back(row);
      is_far[row] = true;
    }
  for (const record::Column& input : record.columns) {
    if (!input.channel->is_input() || rows.empty()) continue;
    double least = unset, most = unset;
    for (std::size_t row = 0; row < values.size(); ++row)
      if (!is_far[row]) {
        least = std::fmin(least, input.values[row]);
        most = std::fmax(most, input.values[row]);
      }
    std::erase_if(rows, [&](std::size_t row) {
      return input.values[row] < least || input.values[row] > most;
    });
  }
  return rows;
}

}  // namespace

std::string Isolated::statement() const {
  const std::string lines = lines_of(record, rows);
  const bool one = rows.size() == 1;
  const std::string beyond = fmt::format("by more than {}the range of the other readings",
                                         by.impossible == 3.0 ? "three times " : "");
  return fmt::format("{} reading{} of {} jump{} and return{}{}{} and {} not used, {} {}",
                     rows.size(), one ? "" : "s", channel->words, one ? "s" : "", one ? "s" : "",
                     by_model    ? " relative to the fitted model"
                     : by.steady ? " while the speed is steady"
                                 : "",
                     !by.steady   ? " " + beyond
                     : impossible ? ", or " + beyond + ","
                                  : std::string(by_model ? "," : ""),
                     one ? "is" : "are", record.lines.empty() ? "rows" : "lines", lines);
}

PossibleRows without_impossible_rows(const record::Record& record) {
  constexpr std::size_t fewest_rows = 15;
  constexpr double coldest = -60.0, hottest = 200.0;  // [C]
  PossibleRows result{.record = record};
  if (record.rows() < fewest_rows) return result;
  const auto take_out = [&](const std::vector<std::size_t>& rows, const std::string& what) {
    const record::Record& now = result.record;
    if (rows.empty() ||
        static_cast<double>(rows.size()) > most_isolated * static_cast<double>(now.rows()))
      return;
    const bool one = rows.size() == 1;
    result.statements.push_back(fmt::format(
        "{} row{} ha{} {} and {} not used, line{} {}", rows.size(), one ? "" : "s",
        one ? "s" : "ve", what, one ? "is" : "are", one ? "" : "s", lines_of(now, rows)));
    std::vector<std::size_t> others;
    for (std::size_t row = 0; row < now.rows(); ++row)
      if (!std::binary_search(rows.begin(), rows.end(), row)) others.push_back(row);
    result.record = now.picked(others);
  };
  for (const record::Column& c : record.columns) {
    if (!c.channel->is_input() || c.channel->offset == 0.0) continue;
    std::vector<std::size_t> rows;
    const std::span<const double> values = result.record.values(*c.channel);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (values[row] < kelvin(coldest) || values[row] > kelvin(hottest)) rows.push_back(row);
    take_out(rows, fmt::format("an impossible {} (outside {:g} to {:g} C)", c.channel->words,
                               coldest, hottest));
  }
  const auto read = std::find_if(record.columns.begin(), record.columns.end(), [](const auto& c) {
    return c.channel->role == record::Role::measured;
  });
  if (read != record.columns.end())
    take_out(far_readings(result.record, *read->channel),
             fmt::format("a {} that differs from all other readings by more than three times the "
                         "range of these readings",
                         read->channel->words));
  return result;
}

Isolated without_isolated_readings(const record::Record& record) {
  for (const record::Column& c : record.columns)
    if (c.channel->role == record::Role::measured)
      return without_isolated_readings(record, *c.channel);
  return {.record = record};
}

Isolated without_isolated_readings(const record::Record& record, const record::Channel& channel,
                                   const Isolation& by, std::span<const double> predicted) {
  const bool by_model = !predicted.empty();
  Isolated result{.record = record, .by = by, .by_model = by_model};
  record::Column* const column = result.record.find(channel);
  if (!column || !record.complete(record::time)) return result;
  std::vector<double> values = column->values;
  for (std::size_t k = 0; k < predicted.size(); ++k) values[k] -= predicted[k];
  const Readings readings(record, std::move(values), by_model);
  const std::vector<bool> steady = steady_ones(readings);
  const std::vector<double> sorted = by_size(readings);
  const double scatter = scatter_of(readings, steady, usual_range(sorted)),
               whole = whole_range(sorted);
  if (!(scatter > 0.0) && !(whole > 0.0)) return result;
  std::vector<bool> isolated(readings.count(), false);
  const std::size_t margin = by_model ? 0 : reach, most = by_model ? longest_by_model : longest;
  for (std::size_t length = 1; length <= most; ++length)
    for (std::size_t k = by_model ? 1 : reach; k + length + margin <= readings.count(); ++k) {
      const std::size_t last = k + length - 1;
      std::size_t before = k - 1, after = last + 1;
      while (before > 0 && isolated[before]) --before;
      while (after + 1 < readings.count() && isolated[after]) ++after;
      // Whether the last readings return nothing tells; a fit is better off without them.
      if (after == readings.count()) after = before > 0 ? before - 1 : before;
      const auto leave_by = [&](double far) {
        return far > 0.0 &&
               leave_and_return(readings, k, last, readings[before], readings[after], far);
      };
      const bool is_steady =
          by.steady && std::all_of(steady.begin() + static_cast<std::ptrdiff_t>(k),
                                   steady.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                   [](bool is) { return is; });
      const bool leaves_all = leave_by(by.impossible * whole);
      if (!leaves_all && !(is_steady && leave_by(far_away * scatter))) continue;
      if (by_model && readings.set_otherwise(k, last, before, after)) continue;
      result.impossible = result.impossible || (leaves_all && !is_steady);
      std::fill_n(isolated.begin() + static_cast<std::ptrdiff_t>(k), length, true);
    }
  for (std::size_t k = 0; k < isolated.size(); ++k)
    if (isolated[k]) result.rows.push_back(readings.row(k));
  if (static_cast<double>(result.rows.size()) >
      most_isolated * static_cast<double>(readings.count()))
    result.rows.clear();
  for (const std::size_t row : result.rows) column->values[row] = unset;
  if (result.any()) result.channel = column->channel;
  return result;
}

}  // namespace raceway::fit
