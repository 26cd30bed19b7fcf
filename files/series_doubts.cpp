#include "files/series_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "algebra/detail/decompositions.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "fit/observations.h"
#include "record/median.h"
#include "record/series_channel.h"
#include "text/units.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;
using record::Role;

constexpr std::size_t fewest_rows = 30;

struct Extent {
  double lower = unset, upper = unset;
  [[nodiscard]] bool known() const { return lower <= upper; }
  [[nodiscard]] double width() const { return upper - lower; }
};

/// All but the lowest and the highest hundredth, which a fault of a sensor may have made.
Extent extent_of(std::span<const double> values) {
  std::vector<double> finite;
  for (const double v : values)
    if (std::isfinite(v)) finite.push_back(v);
  if (finite.empty()) return {};
  const std::size_t cut = finite.size() / 100;
  const auto at = [&](std::size_t k) {
    const auto place = finite.begin() + static_cast<std::ptrdiff_t>(k);
    std::nth_element(finite.begin(), place, finite.end());
    return *place;
  };
  return {at(cut), at(finite.size() - 1 - cut)};
}

/// "14 h", "583 d"
std::string duration_text(double seconds) {
  const char* const unit = seconds < 180.0      ? "s"
                           : seconds < 7200.0   ? "min"
                           : seconds < 172800.0 ? "h"
                                                : "d";
  return fmt::format("{:.3g} {}", text::find_unit(unit, text::Dimension::time)->in_unit(seconds),
                     unit);
}

/// Steps and length of a record over time.
struct Clock {
  double step = unset;    ///< median [s]
  double length = unset;  ///< of the longest run [s]

  explicit Clock(const Record& data) {
    const std::span<const double> time = data.values(record::time);
    std::vector<double> steps;
    length = 0.0;
    for (std::size_t row = 1, first = 0; row < time.size(); ++row) {
      if (data.run_of(row) != data.run_of(row - 1)) first = row;
      if (row > first) steps.push_back(time[row] - time[row - 1]);
      length = std::max(length, time[row] - time[first]);
    }
    step = record::median(steps);
  }

  [[nodiscard]] Doubt looks_like(const text::Unit& unit) const {
    return {.text = fmt::format(
                "the record has a sampling interval of {} and a duration of {}: is "
                "time_s in {} instead of s (then the sampling interval is {} and the duration {})?",
                duration_text(step), duration_text(length), unit.words,
                duration_text(unit.factor * step), duration_text(unit.factor * length)),
            .units = {{&record::time, unit.suffix}}};
  }
};

/// Share of the variance of the readings that no sum of the model's lags explains, each with a gain
/// of its own, where times are `factor` times as long.
double unexplained(const correction::Model& model, Record data, double factor) {
  for (double& t : data.find(record::time)->values) t *= factor;
  const correction::Series series(data);
  const std::vector<correction::Contribution> parts = correction::contributions(model, series);
  const std::span<const double> read = data.values(*model.displacement);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < read.size(); ++row)
    if (std::isfinite(read[row]) && std::all_of(parts.begin(), parts.end(), [&](const auto& p) {
          return std::isfinite(p.displacement[row]);
        }))
      rows.push_back(row);
  if (rows.size() < fewest_rows) return unset;
  const auto n = static_cast<Eigen::Index>(rows.size()),
             m = static_cast<Eigen::Index>(parts.size()) + 1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Ones(n, m);
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t row = rows[static_cast<std::size_t>(i)];
    b[i] = read[row];
    for (std::size_t k = 0; k < parts.size(); ++k)
      A(i, static_cast<Eigen::Index>(k) + 1) = parts[k].displacement[row];
  }
  const double variance = (b.array() - b.mean()).matrix().squaredNorm();
  return variance > 0.0 ? (b - A * algebra::least_squares(A, b)).squaredNorm() / variance : unset;
}

double longest_time_constant(const correction::Model& model) {
  double longest = 0.0;
  for (const correction::DrivenChannel& c : model.channels)
    for (const correction::Section& s : c.sections) longest = std::fmax(longest, s.time_constant);
  return longest;
}

std::optional<Doubt> unit_of_time(const Record& data,
                                  const std::vector<correction::Model>& models) {
  constexpr double slowest = 7200.0, usual_least = 1e-3, usual_most = 3600.0;  // steps [s]
  const Clock clock(data);
  if (clock.step > slowest)
    for (const char* const name : {"ms", "us", "ns"}) {
      const text::Unit& unit = *text::find_unit(name, text::Dimension::time);
      const double step = unit.factor * clock.step;
      if (step >= usual_least && step <= usual_most) return clock.looks_like(unit);
    }
  constexpr double far_better = 0.25, explained = 0.1;
  for (const correction::Model& model : models) {
    const double longest = longest_time_constant(model);
    if (!data.has(*model.displacement) || !(clock.length < longest)) continue;
    for (const char* const name : {"min", "h", "d"}) {
      const text::Unit& unit = *text::find_unit(name, text::Dimension::time);
      if (unit.factor * clock.length < longest || unit.factor * clock.step > usual_most) continue;
      try {
        const double other = unexplained(model, data, unit.factor);
        if (other < explained && other < far_better * unexplained(model, data, 1.0))
          return clock.looks_like(unit);
      } catch (const std::invalid_argument&) {
        // The reader of the record reports it.
      }
    }
  }
  return std::nullopt;
}

/// How a simulation of a spindle goes with the readings.
struct SpindleFit {
  double unexplained =
      unset;              ///< share of the variance that no multiple explains, mean of channels
  double factor = unset;  ///< by which the readings are larger, geometric mean of channels
};

SpindleFit simulated(const model::ModelSubject& spindle, const Record& data) {
  SpindleFit fit;
  try {
    const std::vector<double> predicted = fit::predict(spindle, data);
    const fit::Observations observed = fit::observe(spindle.measured(), data, predicted);
    const std::vector<std::size_t> places = observed.places(data.rows());
    double unexplained = 0.0, logs = 0.0;
    int channels = 0;
    for (std::size_t c = 0; c < observed.channels.size(); ++c) {
      const auto n = observed.size(c), first = observed.first[c];
      if (n < static_cast<Eigen::Index>(fewest_rows)) continue;
      Eigen::VectorXd read = observed.measured.segment(first, n), model(n);
      for (Eigen::Index i = 0; i < n; ++i)
        model[i] = predicted[places[static_cast<std::size_t>(first + i)]];
      read.array() -= read.mean();
      model.array() -= model.mean();
      if (!(read.norm() > 0.0) || !(model.norm() > 0.0)) continue;
      const double alike = read.dot(model) / (read.norm() * model.norm());
      unexplained += alike > 0.0 ? 1.0 - alike * alike : 1.0;
      logs += std::log(read.norm() / model.norm());
      ++channels;
    }
    if (channels > 0) fit = {unexplained / channels, std::exp(logs / channels)};
  } catch (const std::invalid_argument&) {
    // The reader of the record reports it.
  }
  return fit;
}

/// Units in which a channel of a spindle's record may have been written, as far as the record
/// could then be: one of 10 minutes to 10 days whose rows come every hour or faster, or speeds
/// below n d_m = 3e6 mm/min.
std::vector<const text::Unit*> other_units_of_spindle(const Record& data, const Channel& channel,
                                                      const model::ModelSubject& spindle) {
  std::vector<const text::Unit*> units;
  if (channel == record::time) {
    constexpr double short_record = 4.0 * 3600.0, long_record = 10.0 * 86400.0;  // [s]
    constexpr double least = 600.0, slowest = 3600.0;  // of a record and its steps [s]
    const Clock clock(data);
    for (const char* const name : {"min", "h", "d", "ms"}) {
      const text::Unit& unit = *text::find_unit(name, text::Dimension::time);
      const double length = unit.factor * clock.length, step = unit.factor * clock.step;
      const bool odd = unit.factor > 1.0 ? clock.length < short_record : clock.length > long_record;
      if (odd && length >= least && length <= long_record && step <= slowest)
        units.push_back(&unit);
    }
    return units;
  }
  constexpr double slow = 3e5, usual = 3e6;  // n d_m [mm/min]
  const double pitch = spindle.model().bearing.pitch_diameter() / mm;
  const double fastest = channel.in_unit(extent_of(data.values(channel)).upper) * pitch;
  if (!(fastest > 0.0 && fastest < slow)) return units;
  for (const char* const name : {"1/s", "rad/s", "krpm"}) {
    const text::Unit& unit = *text::find_unit(name, text::Dimension::speed);
    if (unit.factor / rpm * fastest < usual) units.push_back(&unit);
  }
  return units;
}

Doubt other_unit_of_spindle(const Record& data, const Channel& channel, const text::Unit& unit) {
  if (channel == record::time) return Clock(data).looks_like(unit);
  const double fastest = extent_of(data.values(channel)).upper;
  return {.text = fmt::format("speeds up to {:.4g} rpm do not agree with the readings, but speeds "
                              "up to {:.4g} rpm do: are the values in {} instead of rpm?",
                              channel.in_unit(fastest),
                              channel.in_unit(unit.to_SI(channel.in_unit(fastest))), unit.words),
          .units = {{&channel, unit.suffix}}};
}

std::optional<Doubt> unit_of_spindle(const Record& data, const Channel& channel,
                                     const model::ModelSubject& spindle) {
  constexpr double far_better = 0.25, explained = 0.3, legitimate = 3.0;
  const auto is_off = [&](const SpindleFit& f) {
    return !(std::abs(std::log(f.factor)) < std::log(legitimate));
  };
  const std::vector<const text::Unit*> units = other_units_of_spindle(data, channel, spindle);
  if (units.empty()) return std::nullopt;
  SpindleFit as_read = simulated(spindle, data);
  if (as_read.unexplained < explained * far_better && !is_off(as_read)) return std::nullopt;
  if (std::isnan(as_read.unexplained)) as_read.unexplained = 1.0;
  const double enough = is_off(as_read) ? 1.0 : far_better;
  SpindleFit best;
  const text::Unit* likely = nullptr;
  for (const text::Unit* const unit : units) {
    const SpindleFit other = simulated(spindle, in_other_unit(data, channel, *unit));
    if (other.unexplained < std::min(explained, enough * as_read.unexplained) && !is_off(other) &&
        !(other.unexplained > best.unexplained))
      best = other, likely = unit;
  }
  return likely ? std::optional(other_unit_of_spindle(data, channel, *likely)) : std::nullopt;
}

/// True for a temperature, never below `from`, that begins where the coldest sensor does once it is
/// taken for Fahrenheit: all parts of a machine that has stood are as warm as the room.
bool begins_as_fahrenheit(double from, double coldest) {
  constexpr double warm_room = 45.0, alike = 1.5;  // [C], [K]
  const text::Unit& fahrenheit = *text::find_unit("F", text::Dimension::temperature);
  return from > warm_room && coldest < warm_room &&
         std::abs(fahrenheit.to_SI(from) - kelvin(coldest)) < alike;
}

void look_at_temperatures(const Record& data, std::vector<Doubt>& found) {
  constexpr double warm_room = 59.0, hot_room = 50.0;  // [C]
  std::vector<std::pair<const Channel*, Extent>> sensors;
  double coldest_of_all = std::numeric_limits<double>::infinity();
  for (const record::Column& c : data.columns) {
    if (!record::is_temperature(*c.channel)) continue;
    if (const Extent extent = extent_of(c.values); extent.known()) {
      sensors.emplace_back(c.channel, extent);
      coldest_of_all = std::min(coldest_of_all, c.channel->in_unit(extent.lower));
    }
  }
  for (const auto& [channel, extent] : sensors) {
    const double from = channel->in_unit(extent.lower), to = channel->in_unit(extent.upper);
    if (from > 220.0 && to < 470.0)
      found.push_back(other_temperature(*channel, from, to, "K"));
    else if (to < 220.0 &&
             (coldest_of_all >= warm_room || (record::is_ambient(*channel) && from > hot_room) ||
              begins_as_fahrenheit(from, coldest_of_all)))
      found.push_back(other_temperature(*channel, from, to, "F"));
  }
}

/// Widest range of a temperature [K].
double warming_of(const Record& data) {
  double most = 0.0;
  for (const record::Column& c : data.columns)
    if (record::is_temperature(*c.channel)) most = std::fmax(most, extent_of(c.values).width());
  return most;
}

void look_at_displacements(const Record& data, std::vector<Doubt>& found) {
  // Angles alike: a micrometre over a metre is a microradian.
  constexpr double least_warming = 2.0;                               // [K]
  constexpr double little = 0.02 * um, much = 300.0 * um;             // [m/K] or [rad/K]
  constexpr double usual_least = 0.05 * um, usual_most = 100.0 * um;  // [m/K] or [rad/K]
  constexpr std::array lengths{"mm", "m", "nm"};
  constexpr std::array angles{"arcsec", "mrad", "deg", "rad"};
  const double warming = warming_of(data);
  if (!(warming > least_warming)) return;
  for (const record::Column& c : data.columns) {
    const bool is_angle = record::is_angle(*c.channel);
    const text::Dimension kind = is_angle ? text::Dimension::angle : text::Dimension::length;
    if (c.channel->role != Role::measured ||
        unit_of(*c.channel) != text::find_unit(is_angle ? "urad" : "um"))
      continue;
    const double rate = extent_of(c.values).width() / warming;
    if (!(rate > 0.0) || (rate > little && rate < much)) continue;
    // Several may be possible: the one whose rate is nearest to the middle of the usual ones.
    const text::Unit* likely = nullptr;
    const auto rate_in = [&](const text::Unit& unit) { return unit.factor / um * rate; };
    const auto apart = [&](const text::Unit& unit) {
      return std::abs(std::log(rate_in(unit) / std::sqrt(usual_least * usual_most)));
    };
    for (const char* const name :
         is_angle ? std::span<const char* const>(angles) : std::span<const char* const>(lengths)) {
      const text::Unit& unit = *text::find_unit(name, kind);
      if (rate_in(unit) < usual_least || rate_in(unit) > usual_most) continue;
      if (!likely || apart(unit) < apart(*likely)) likely = &unit;
    }
    if (!likely) continue;
    found.push_back(
        {.text = fmt::format("{} changes by {:.3g} {} for each kelvin of the temperature that "
                             "changes most: are the values in {} (then the change is {:.3g} {}/K)?",
                             c.channel->name, rate / um, c.channel->unit, likely->words,
                             rate_in(*likely) / um, c.channel->unit),
         .units = {{c.channel, likely->suffix}}});
  }
}

}  // namespace

std::vector<Doubt> series_doubts(const Record& data, const std::vector<correction::Model>& models) {
  std::vector<Doubt> found;
  if (data.rows() < fewest_rows) return found;
  if (auto doubt = unit_of_time(data, models)) found.push_back(*std::move(doubt));
  look_at_temperatures(data, found);
  // A kelvin in Fahrenheit is no kelvin.
  if (found.empty()) look_at_displacements(data, found);
  return found;
}

std::vector<Doubt> series_doubts(const Record& data, const model::ModelSubject& spindle) {
  std::vector<Doubt> found = series_doubts(data, std::vector<correction::Model>());
  if (!found.empty() || data.rows() < fewest_rows) return found;
  for (const Channel* const channel : {&record::time, &record::speed})
    if (found.empty() && data.has(*channel))
      if (auto doubt = unit_of_spindle(data, *channel, spindle)) found.push_back(*std::move(doubt));
  return found;
}

}  // namespace raceway::files
