#include "fit/dwells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "record/levels.h"
#include "record/median.h"

namespace raceway::fit {

namespace {

using record::Channel;
using record::Column;
using record::Record;
using record::Role;

constexpr std::size_t fewest_rows_of_a_dwell = 5;
constexpr double longest_pause = 120.0;  // between rows of one dwell [s]
constexpr double of_own_size = 0.02;  // a setting moves by no more than that, however small it is
constexpr double standstill = 1e-3;   // of the largest: less is none
constexpr double longest_step_of_a_ramp = 5.0;  // from row to row [s]
constexpr double most_drift = 1.0;              // of a temperature within one mean [K]
constexpr std::size_t smoothing = 9;   // rows over which a temperature is averaged to see it move
constexpr std::size_t with_trend = 8;  // rows from which a trend is told from scatter
constexpr double drift_worth_a_trend = 0.2;  // of a temperature over a dwell [K]
constexpr double worth_a_memory = 3.84;      // of -2 ln L: 5 % level of one parameter
constexpr std::size_t rows_of_a_search = 4000;
constexpr std::array correlations{0.0, 0.3, 0.5, 0.65, 0.77, 0.85, 0.9, 0.935, 0.96, 0.975, 0.985};
constexpr std::array white_shares{0.0, 0.1, 0.25, 0.5, 0.75, 0.9};

/// Rows from `first` to before `last`.
struct Stay {
  std::size_t first = 0, last = 0;
  std::size_t state = 0;
  bool dwell = false;
  [[nodiscard]] std::size_t rows() const { return last - first; }
};

/// A setting that is held during a dwell.
struct Held {
  std::span<const double> values;
  double step = 0.0, least = 0.0;

  /// Largest distance of a row from the mean of its dwell.
  [[nodiscard]] double width(double about) const {
    return std::max(std::min(step, of_own_size * std::abs(about)), least);
  }
};

std::vector<Held> held_settings(const Record& record) {
  std::vector<Held> list;
  for (const Column& c : record.columns) {
    if (c.channel->role != Role::setting || !c.channel->ratio) continue;
    const double step = record::step_of(*c.channel, c.values);
    list.push_back({c.values, step, standstill * step / c.channel->step});
  }
  return list;
}

double mean_of(std::span<const double> values, const Stay& s) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = s.first; i < s.last; ++i)
    if (std::isfinite(values[i])) {
      sum += values[i];
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : unset;
}

/// Change over a stretch, by its regression on the number of the row, and the share of the
/// variance that it explains.
struct Trend {
  double change = 0.0, share = 0.0;
};

Trend trend_of(std::span<const double> values, const Stay& s) {
  const double middle = 0.5 * static_cast<double>(s.rows() - 1), about = mean_of(values, s);
  double product = 0.0, square = 0.0, all = 0.0;
  for (std::size_t i = s.first; i < s.last; ++i) {
    const double t = static_cast<double>(i - s.first) - middle;
    product += t * (values[i] - about);
    square += t * t;
    all += std::pow(values[i] - about, 2);
  }
  if (!(square > 0.0 && all > 0.0)) return {};
  return {2.0 * middle * product / square, product * product / (square * all)};
}

/// Cuts a record where a setting changes, a run ends or time passes.
std::vector<Stay> stays_of(const Record& record, const std::vector<Held>& held) {
  std::vector<Stay> list;
  std::vector<double> sums(held.size(), 0.0);
  for (std::size_t i = 0; i < record.rows(); ++i) {
    bool goes_on = i > 0 && record.run_of(i) == record.run_of(i - 1) &&
                   record.part_of(i) == record.part_of(i - 1);
    if (goes_on && record.has(record::time)) {
      const double step = record.value(record::time, i) - record.value(record::time, i - 1);
      goes_on = step >= 0.0 && step <= longest_pause;
    }
    for (std::size_t k = 0; k < held.size() && goes_on; ++k) {
      const double about = sums[k] / static_cast<double>(list.back().rows());
      const double value = held[k].values[i];
      // A setting that no row has is none.
      goes_on = (std::isnan(value) && std::isnan(about)) ||
                std::abs(value - about) <= held[k].width(about);
    }
    if (!goes_on) {
      list.push_back({.first = i, .last = i});
      std::fill(sums.begin(), sums.end(), 0.0);
    }
    ++list.back().last;
    for (std::size_t k = 0; k < held.size(); ++k) sums[k] += held[k].values[i];
  }
  return list;
}

/// True where the settings stand and do not move on from row to row.
bool is_dwell(const Stay& s, const std::vector<Held>& held) {
  return s.rows() >= fewest_rows_of_a_dwell &&
         std::none_of(held.begin(), held.end(), [&](const Held& setting) {
           const double width = setting.width(mean_of(setting.values, s));
           const Trend trend = trend_of(setting.values, s);
           return std::abs(trend.change) > width ||
                  (std::abs(trend.change) > 0.25 * width && trend.share > 0.5);
         });
}

/// Numbers the states: dwells with nothing but stray rows between them stand at one where they have
/// the same settings.
void number_states(std::vector<Stay>& list, const std::vector<Held>& held, const Record& record) {
  const Stay* before = nullptr;
  std::size_t states = 0;
  for (Stay& s : list) {
    if (!s.dwell) {
      s.state = states++;
      continue;
    }
    const bool same =
        before && record.run_of(before->first) == record.run_of(s.first) &&
        record.part_of(before->first) == record.part_of(s.first) &&
        std::all_of(held.begin(), held.end(), [&](const Held& setting) {
          const double a = mean_of(setting.values, *before), b = mean_of(setting.values, s);
          return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= setting.width(a);
        });
    s.state = same ? before->state : states++;
    before = &s;
  }
}

/// Ends of the pieces in which no temperature moves by more than 1 K, behind the last row of each.
std::vector<std::size_t> pieces_of(const Record& record, const Stay& s) {
  std::vector<std::vector<double>> smooth;
  for (const Column& c : record.columns) {
    if (!c.channel->is_input() || c.channel->ratio) continue;
    std::vector<double>& own = smooth.emplace_back();
    for (std::size_t i = s.first; i < s.last; ++i) {
      const std::size_t half = std::min({smoothing / 2, i - s.first, s.last - 1 - i});
      own.push_back(mean_of(c.values, {.first = i - half, .last = i + half + 1}));
    }
  }
  std::vector<std::size_t> ends;
  std::size_t first = 0;
  for (std::size_t i = 1; i < s.rows(); ++i)
    if (std::any_of(smooth.begin(), smooth.end(), [&](const std::vector<double>& own) {
          const auto [low, high] =
              std::minmax_element(own.begin() + static_cast<std::ptrdiff_t>(first),
                                  own.begin() + static_cast<std::ptrdiff_t>(i) + 1);
          return *high - *low > most_drift;
        })) {
      ends.push_back(s.first + i);
      first = i;
    }
  ends.push_back(s.last);
  return ends;
}

/// Covariance of two readings within a dwell: s² (w white + (1 - w) φ^|i - k|), s = scale
/// |y|^power.
struct Scatter {
  double scale = 0.0, power = 0.0, correlation = 0.0, white = 1.0;

  [[nodiscard]] double std_of_mean(double reading, std::size_t rows) const {
    const auto m = static_cast<double>(rows);
    double sum = m, decay = 1.0;
    for (std::size_t k = 1; k < rows; ++k) {
      decay *= correlation;
      sum += 2.0 * (m - static_cast<double>(k)) * decay;
    }
    return scale * std::pow(reading, power) * std::sqrt(white / m + (1.0 - white) * sum / (m * m));
  }
};

/// Readings of one channel within the dwells, each by its size.
class ScatterSearch {
 public:
  ScatterSearch(const Record& record, const Channel& measured, const std::vector<Stay>& means) {
    const std::span<const double> readings = record.values(measured);
    double largest = 0.0;
    for (const double y : readings) largest = std::fmax(largest, std::abs(y));
    least_ = 1e-2 * largest;
    find_power(readings, means);
    std::size_t taken = 0;
    for (const Stay& s : means) {
      if (!s.dwell || taken > rows_of_a_search) continue;
      const double size = std::pow(size_of(mean_of(readings, s)), found_.power);
      Dwelt own;
      for (std::size_t i = s.first; i < s.last; ++i)
        if (std::isfinite(readings[i])) own.readings.push_back(readings[i] / size);
      own.trend = own.readings.size() >= with_trend && drifts(record, s);
      taken += own.readings.size();
      if (own.readings.size() >= 2) dwells_.push_back(std::move(own));
    }
  }

  [[nodiscard]] double size_of(double reading) const { return std::max(std::abs(reading), least_); }

  Scatter run() {
    double best = std::numeric_limits<double>::infinity();
    for (const double phi : correlations)
      for (const double white : white_shares) {
        if (phi == 0.0 && white > 0.0) break;
        double variance = 0.0;
        const double value = restricted(phi, white, variance) +
                             worth_a_memory * ((phi > 0.0 ? 1.0 : 0.0) + (white > 0.0 ? 1.0 : 0.0));
        if (!(value < best)) continue;
        best = value;
        found_.scale = std::sqrt(variance);
        found_.correlation = phi;
        found_.white = phi == 0.0 ? 1.0 : white;
      }
    return found_;
  }

 private:
  /// The readings of a dwell, each by its size.
  struct Dwelt {
    std::vector<double> readings{};
    bool trend = false;  ///< they follow a temperature that drifts
  };

  static bool drifts(const Record& record, const Stay& s) {
    return std::any_of(record.columns.begin(), record.columns.end(), [&](const Column& c) {
      return c.channel->is_input() && !c.channel->ratio &&
             std::abs(trend_of(c.values, s).change) > drift_worth_a_trend;
    });
  }

  /// With which power of the reading the scatter grows, from 0 (absolute) to 2.
  void find_power(std::span<const double> readings, const std::vector<Stay>& means) {
    double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Stay& s : means) {
      if (!s.dwell) continue;
      const double about = mean_of(readings, s);
      double square = 0.0;
      for (std::size_t i = s.first; i < s.last; ++i)
        if (std::isfinite(readings[i])) square += std::pow(readings[i] - about, 2);
      if (!(square > 0.0)) continue;
      const auto w = static_cast<double>(s.rows() - 1);
      const double a = std::log(size_of(about)), b = 0.5 * std::log(square / w);
      weight += w;
      x += w * a;
      y += w * b;
      xx += w * a * a;
      xy += w * a * b;
    }
    const double spread = weight * xx - x * x;
    if (spread > 1e-9 * weight * xx)
      found_.power = std::clamp((weight * xy - x * y) / spread, 0.0, 2.0);
  }

  /// -2 ln of the restricted likelihood of all dwells, each about its own mean and, where its
  /// temperature drifts, trend; innovations of the Kalman filter of the correlated part.
  [[nodiscard]] double restricted(double phi, double white, double& variance) const {
    double log_determinant = 0.0, square = 0.0, freedom = 0.0;
    for (const auto& [y, trend] : dwells_) {
      const double middle = 0.5 * static_cast<double>(y.size() - 1);
      std::array<double, 3> state{};  // of the readings, of ones, of the trend
      double p = 1.0 - white;
      double oo = 0.0, to = 0.0, tt = 0.0, oy = 0.0, ty = 0.0, yy = 0.0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        if (i > 0) p = phi * phi * p + (1.0 - phi * phi) * (1.0 - white);
        const double s = p + white;
        const std::array<double, 3> seen{y[i], 1.0, static_cast<double>(i) - middle};
        std::array<double, 3> e{};
        for (std::size_t k = 0; k < 3; ++k) {
          if (i > 0) state[k] *= phi;
          e[k] = seen[k] - state[k];
          state[k] += p / s * e[k];
        }
        log_determinant += std::log(s);
        yy += e[0] * e[0] / s;
        oy += e[0] * e[1] / s;
        oo += e[1] * e[1] / s;
        ty += e[0] * e[2] / s;
        to += e[1] * e[2] / s;
        tt += e[2] * e[2] / s;
        p -= p * p / s;
      }
      log_determinant += std::log(oo);
      yy -= oy * oy / oo;
      freedom += static_cast<double>(y.size()) - 1.0;
      if (trend) {
        const double own = tt - to * to / oo, with = ty - to * oy / oo;
        log_determinant += std::log(own);
        yy -= with * with / own;
        freedom -= 1.0;
      }
      square += std::max(yy, 0.0);
    }
    variance = freedom > 0.0 ? square / freedom : unset;
    return freedom * std::log(square) + log_determinant;
  }

  Scatter found_;
  double least_ = 0.0;
  std::vector<Dwelt> dwells_;
};

/// Mean step of time within dwells.
double step_of_time(const Record& record, const std::vector<Stay>& means) {
  std::vector<double> steps;
  for (const Stay& s : means)
    if (s.dwell)
      for (std::size_t i = s.first + 1; i < s.last; ++i)
        steps.push_back(record.value(record::time, i) - record.value(record::time, i - 1));
  return record::median(steps);
}

/// True for a row of a fast ramp of the first setting between rows at the usual step of time.
bool is_on_ramp(const Record& record, const Held& setting, std::size_t i, double usual_step) {
  constexpr double about_the_usual = 2.0;
  if (i == 0 || i + 1 == record.rows()) return false;
  const auto follows = [&](std::size_t row) {
    const double step = record.value(record::time, row) - record.value(record::time, row - 1);
    return step <= about_the_usual * usual_step && record.run_of(row) == record.run_of(row - 1) &&
           record.part_of(row) == record.part_of(row - 1);
  };
  const double before = setting.values[i - 1], here = setting.values[i],
               after = setting.values[i + 1];
  return follows(i) && follows(i + 1) && (here - before) * (after - here) >= 0.0 &&
         std::abs(after - before) > 2.0 * setting.width(here);
}

/// The scatter of the means of the one channel that was measured: of several each has another.
void add_scatter(const Record& record, const std::vector<Stay>& means, Averaged& result) {
  const Column* measured = nullptr;
  for (const Column& c : record.columns) {
    if (c.channel->role != Role::measured) continue;
    if (measured) return;
    measured = &c;
  }
  if (!measured) return;
  ScatterSearch search(record, *measured->channel, means);
  const Scatter scatter = search.run();
  if (!(scatter.scale > 0.0)) return;
  std::vector<double> of_mean;
  double square = 0.0;
  const std::span<const double> readings = result.record.values(*measured->channel);
  for (std::size_t k = 0; k < means.size(); ++k) {
    of_mean.push_back(scatter.std_of_mean(search.size_of(readings[k]), means[k].rows()));
    if (std::isfinite(readings[k])) square += readings[k] * readings[k];
  }
  const double size = std::sqrt(square / static_cast<double>(means.size()));
  for (double& v : of_mean) v /= size;
  result.record.set(dwell_scatter, std::move(of_mean));
  if (!(scatter.correlation > 0.0)) return;
  result.correlation_time = -step_of_time(record, means) / std::log(scatter.correlation);
}

/// Readings with a standard deviation of their own are known one by one.
bool has_deviations(const Record& record) {
  return std::any_of(record.columns.begin(), record.columns.end(),
                     [](const Column& c) { return c.channel->role == Role::deviation; });
}

}  // namespace

Averaged average_dwells(const Record& record) {
  Averaged result{.rows = record.rows()};
  if (has_deviations(record) || record.rows() == 0) return result;
  const std::vector<Held> held = held_settings(record);
  if (held.empty()) return result;
  std::vector<Stay> found = stays_of(record, held);
  for (Stay& s : found) s.dwell = is_dwell(s, held);
  number_states(found, held, record);
  std::vector<Stay> means;
  const auto take_rows = [&](const Stay& s) {
    for (std::size_t i = s.first; i < s.last; ++i)
      means.push_back({.first = i, .last = i + 1, .state = found.size() + i});
    result.alone += s.rows();
  };
  for (const Stay& s : found) {
    const std::vector<std::size_t> ends =
        s.dwell ? pieces_of(record, s) : std::vector<std::size_t>{};
    // A temperature that is stepped from row to row is a setting, not what a dwell drifts by.
    if (ends.empty() || s.rows() < fewest_rows_of_a_dwell * ends.size()) {
      take_rows(s);
      continue;
    }
    std::size_t first = s.first;
    for (const std::size_t end : ends) {
      means.push_back({.first = first, .last = end, .state = s.state, .dwell = true});
      first = end;
    }
    result.dwells += ends.size();
    result.split += ends.size() > 1 ? 1 : 0;
  }
  // A few rows that happen to stand still make no dwells of a ramp, and one operating point none of
  // a record.
  if (!result.any() || means.size() < 2 || 2 * result.alone > record.rows())
    return {.rows = record.rows()};
  // With one dwell, the ramp is the measurement.
  if (const double usual = record.has(record::time) ? step_of_time(record, means) : unset;
      result.dwells > 1 && usual <= longest_step_of_a_ramp) {
    result.ramps = std::erase_if(means, [&](const Stay& s) {
      return !s.dwell && is_on_ramp(record, held.front(), s.first, usual);
    });
    result.alone -= result.ramps;
  }
  std::vector<std::size_t> wanted;
  for (const Stay& s : means) wanted.push_back(s.first);
  result.record = record.picked(wanted);
  for (std::size_t c = 0; c < record.columns.size(); ++c) {
    const Column& from = record.columns[c];
    if (from.channel->role == Role::run || from.channel->role == Role::part) continue;
    result.channels.push_back(from.channel);
    for (std::size_t k = 0; k < means.size(); ++k)
      if (means[k].dwell) result.record.columns[c].values[k] = mean_of(from.values, means[k]);
  }
  const auto add = [&](const Channel& channel, const auto& value) {
    std::vector<double> values;
    for (const Stay& s : means) values.push_back(static_cast<double>(value(s)));
    result.record.set(channel, std::move(values));
  };
  add(dwell_rows, [](const Stay& s) { return s.rows(); });
  add(dwell_last_line, [&](const Stay& s) { return record.line(s.last - 1); });
  add(dwell_state, [](const Stay& s) { return s.state; });
  add_scatter(record, means, result);
  return result;
}

std::string Averaged::statement() const {
  std::vector<std::string_view> words;
  for (const Channel* channel : channels) words.push_back(channel->words);
  std::string text =
      fmt::format("{} rows form {} dwell{}", rows - alone - ramps, dwells, dwells == 1 ? "" : "s");
  if (alone > 0)
    text += fmt::format(", and {} row{} outside of dwells", alone, alone == 1 ? " is" : "s are");
  text += fmt::format(": the program averages the {} of consecutive rows at equal settings",
                      fmt::join(words, ", "));
  if (split > 0)
    text += fmt::format("; {} dwell{} divided where a temperature changed by more than 1 K", split,
                        split == 1 ? " is" : "s are");
  if (ramps > 0)
    text += fmt::format("; {} row{} on fast ramps between dwells {} not used", ramps,
                        ramps == 1 ? "" : "s", ramps == 1 ? "is" : "are");
  if (correlation_time > 0.0)
    text += fmt::format("; the scatter within a dwell has a correlation time of {:.2g} s",
                        correlation_time);
  return text;
}

}  // namespace raceway::fit
