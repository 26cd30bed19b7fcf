#include "correction/record_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/numbers.h"
#include "correction/quantum.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "record/median.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double stuck_for = 1800.0;  // [s]
constexpr double a_jump = 20.0;       // times the usual step, and
constexpr double a_leap = 0.25;       // of the range, in one row

std::string amount(const Channel& c, double si) {
  return fmt::format("{:.3g} {}", si / c.factor, record::is_temperature(c) ? "K" : c.unit);
}

class Checking {
 public:
  Checking(const Model& model, const record::Record& record)
      : model_(model), record_(record), series_(record) {}

  RecordCheck run() {
    result_.displacement = model_.displacement;
    look_at_time();
    for (const record::Column& c : record_.columns)
      if (c.channel->is_input()) look_at(c);
    look_at_readings();
    look_at_model();
    return std::move(result_);
  }

 private:
  void warn(record::Note said) {
    said.place.file = record_.source;
    result_.warnings.push_back(std::move(said));
  }

  void warn_of(const Channel& channel, std::string text) {
    const record::Note said = record::note::sensor(
        std::move(text), {.file = record_.source, .key = std::string(channel.name)});
    const std::vector<const Channel*> inputs = inputs_of(model_);
    if (std::any_of(inputs.begin(), inputs.end(), [&](const Channel* c) { return *c == channel; }))
      result_.of_its_inputs.push_back(said);
    warn(said);
  }

  void look_at_time() {
    result_.sampling = series_.sampling();
    result_.duration = series_.duration();
    if (std::isnan(result_.sampling)) return;
    const TimeConstantLimits shown = time_constants_of(series_);
    result_.shortest = shown.shortest;
    result_.longest = shown.longest;
  }

  void look_at(const record::Column& c) {
    const Channel& channel = *c.channel;
    if (const double q = quantum_of(channel, c.values); std::isfinite(q))
      result_.quanta.push_back({&channel, q});
    const auto [low, high] = std::minmax_element(c.values.begin(), c.values.end());
    // A speed or a feed that stays what it is from the first row on is a step from rest.
    const bool is_step =
        *low != 0.0 && record::course_of(channel) == record::Course::held && channel.is_input();
    if (*low == *high && is_step) return;
    if (*low == *high)
      return warn_of(channel,
                     fmt::format("{} does not vary, so it gives no information", channel.name));
    if (record::is_temperature(channel)) look_for_faults(c);
  }

  /// A temperature that stands still to the last digit while others move, or leaps.
  void look_for_faults(const record::Column& c) {
    const Channel& channel = *c.channel;
    std::vector<double> steps;
    for (std::size_t k = 1; k < c.values.size(); ++k)
      if (!series_.clock().begins[k]) steps.push_back(std::abs(c.values[k] - c.values[k - 1]));
    const auto [low, high] = std::minmax_element(c.values.begin(), c.values.end());
    const double usual = std::fmax(record::median(steps), quantum_of_column(channel));
    const double leap = std::max(a_jump * usual, a_leap * (*high - *low));
    std::size_t jumps = 0, first_jump = 0;
    for (std::size_t k = 1; k < c.values.size(); ++k) {
      const bool gap = series_.clock().steps[k] > a_gap * result_.sampling;
      if (!series_.clock().begins[k] && !gap && std::abs(c.values[k] - c.values[k - 1]) > leap) {
        if (jumps++ == 0) first_jump = k;
      }
    }
    const Still still = longest_still(record_, c.values);
    if (still.longest > stuck_for && others_move(c, still.from, still.from + still.longest))
      warn_of(channel, fmt::format("{} is constant for {:.3g} min from {:.4g} s on, while other "
                                   "columns change: check the sensor",
                                   channel.name, still.longest / 60.0, still.from));
    if (jumps > 0)
      warn_of(
          channel,
          fmt::format(
              "{} jumps by more than {} between two rows ({} time{}; the first jump ends at {})",
              channel.name, amount(channel, leap), jumps, jumps == 1 ? "" : "s",
              record_.place(first_jump)));
  }

  /// Whether another temperature goes over a good part of its range between two times.
  [[nodiscard]] bool others_move(const record::Column& than, double from, double to) const {
    constexpr double good_part = 0.25;
    const std::span<const double> time = record_.values(record::time);
    for (const record::Column& c : record_.columns) {
      // A room may stand still whatever the spindle does.
      const bool mover = record::is_temperature(*c.channel) ||
                         (*c.channel == record::speed && !record::is_ambient(*than.channel));
      if (c.channel == than.channel || !mover) continue;
      const auto [low, high] = std::minmax_element(c.values.begin(), c.values.end());
      double least = unset, most = unset;
      for (std::size_t k = 0; k < c.values.size(); ++k)
        if (time[k] >= from && time[k] <= to)
          least = std::fmin(least, c.values[k]), most = std::fmax(most, c.values[k]);
      if (most - least > good_part * (*high - *low)) return true;
    }
    return false;
  }

  [[nodiscard]] double quantum_of_column(const Channel& channel) const {
    for (const RecordCheck::Quantum& q : result_.quanta)
      if (*q.column == channel) return q.step;
    return unset;
  }

  void look_at_readings() {
    const std::span<const double> time = record_.values(record::time),
                                  read = record_.values(*model_.displacement);
    std::vector<double> intervals;
    double last = unset;
    for (std::size_t k = 0; k < read.size(); ++k) {
      if (std::isnan(read[k])) continue;
      ++result_.readings;
      if (!std::isnan(last)) intervals.push_back(time[k] - last);
      last = time[k];
    }
    result_.reading_interval = record::median(intervals);
    result_.repeatability = fit::repeatability(record_, *model_.displacement);
    if (result_.repeatability.known()) return;
    if (result_.reading_interval > 120.0)
      result_.noise_at_most = fit::noise_of_calm_readings(record_, *model_.displacement);
    if (result_.readings > 0 && result_.reading_interval > 120.0)
      warn(record::note::noise(
          fmt::format("readings come every {:.3g} s, which is too slow to estimate the noise of "
                      "the sensor; give {} in the model",
                      result_.reading_interval, in_unit_of(model_, "measurement_std_um"))));
  }

  void look_at_model() {
    for (const DrivenChannel& c : model_.channels) {
      for (std::size_t s = 0; s < c.sections.size(); ++s)
        if (const double tau = c.sections[s].time_constant; 3.0 * tau > result_.duration)
          warn(record::note::not_identifiable(
              fmt::format("channel {}: the time constant of {:.4g} s is more than a third of the "
                          "record of {:.4g} s, so the record does not determine it",
                          c.name, tau, result_.duration),
              {.key = c.name}));
      if (c.printed) {
        double quantum = 0.1 * c.input.factor();
        for (const Channel* column : c.input.columns)
          if (const double q = quantum_of_column(*column); std::isfinite(q)) quantum = q;
        result_.printed.push_back(
            {c.name, c.input.factor(), quantum, check(*c.printed, quantum, unit_of(model_))});
        for (const std::string& text : result_.printed.back().check.warnings)
          warn(record::note::polynomial(fmt::format("channel {}: {}", c.name, text),
                                        {.key = c.name}));
      }
      if (c.feedthrough == 0.0) continue;
      for (const Channel* column : c.input.columns)
        if (const double q = quantum_of_column(*column); std::isfinite(q))
          warn(record::note::sensor(
              fmt::format("channel {}: a step of the last digit of {} ({}) immediately moves the "
                          "predicted displacement by {:.3g} {}",
                          c.name, column->name, amount(*column, q),
                          std::abs(c.feedthrough * q) / um, unit_of(model_)),
              {.key = c.name}));
    }
  }

  const Model& model_;
  const record::Record& record_;
  Series series_;
  RecordCheck result_;
};

}  // namespace

std::string beyond_element(const Model& model, const record::Record& record) {
  const Series series(record);
  for (const DrivenChannel& c : model.channels) {
    if (!c.element) continue;
    const Interval takes = c.element->domain();
    const Series::Values input = series.input(c.input);
    for (std::size_t k = 0; k + 1 < input->size(); ++k) {
      const double x = (*input)[k] / c.input.factor();
      if (series.clock().begins[k + 1] || (x >= takes.lower && x < takes.upper)) continue;
      const std::string_view unit = c.input.unit();
      return fmt::format(
          "channel {}: {:.4g} {} in {}: this {} is outside the range of the delay element, because "
          "the time constant of the element is positive only {}",
          c.name, x, unit, record.place(k), c.input.is_power() ? "power" : "input",
          std::isfinite(takes.lower) && takes.lower != 0.0
              ? fmt::format("from {:.4g} to {:.4g} {}", takes.lower, takes.upper, unit)
          : x < 0.0 ? fmt::format("at 0 {} or more", unit)
                    : fmt::format("below {:.4g} {}", takes.upper, unit));
    }
  }
  return {};
}

RecordCheck check_record(const Model& model, const record::Record& record) {
  return Checking(model, record).run();
}

}  // namespace raceway::correction
