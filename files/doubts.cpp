#include "files/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "fit/observations.h"
#include "fit/response.h"
#include "fit/thinned.h"
#include "model/row.h"
#include "model/steps.h"
#include "record/median.h"
#include "record/series_channel.h"
#include "text/units.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;
using record::Role;

constexpr std::size_t least_rows = 5, most_rows = 300;
constexpr double legitimate = 5.0;  // what free parameters may be off
// What a lubricant in a bearing is not [K].
const double coldest = kelvin(-60), hottest = kelvin(200);

/// How readings stand to predictions, as logarithms.
struct Ratio {
  double middle = unset;  ///< median of ln |reading / prediction|
  double spread = unset;  ///< median distance from it
  double opposite = 0.0;  ///< share of rows in which the signs differ
  double correlation = 0.0;
  std::size_t rows = 0;

  [[nodiscard]] bool known() const { return rows >= least_rows; }
  [[nodiscard]] bool far() const { return known() && std::abs(middle) > std::log(legitimate); }
  /// Share of the variance of the readings that no multiple of the prediction explains.
  [[nodiscard]] double unexplained() const { return 1.0 - correlation * correlation; }
  [[nodiscard]] bool near(double factor, double within) const {
    return known() && std::abs(std::abs(middle) - std::log(factor)) < std::log(within);
  }
};

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum_a += a[i], sum_b += b[i];
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] - sum_a / n, y = b[i] - sum_b / n;
    aa += x * x, bb += y * y, ab += x * y;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

/// Of the leading channel. Predictions near zero say nothing.
Ratio ratio_of(const model::ModelSubject& subject, const Record& data) {
  const Channel& channel = *subject.measured().front().channel;
  const std::span<const double> read = data.values(channel);
  std::vector<double> predicted;
  try {
    predicted = fit::predict(subject, data);
  } catch (const std::invalid_argument&) {
    return {};  // the reader of the record reports it
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < read.size(); ++i)
    if (std::isfinite(predicted[i])) largest = std::max(largest, std::abs(predicted[i]));
  std::vector<double> logs, a, b;
  Ratio ratio;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!std::isfinite(predicted[i]) || !(std::abs(predicted[i]) > 0.05 * largest)) continue;
    if (!std::isfinite(read[i]) || read[i] == 0.0) continue;
    logs.push_back(std::log(std::abs(read[i] / predicted[i])));
    a.push_back(read[i]);
    b.push_back(predicted[i]);
    ratio.opposite += (read[i] < 0) != (predicted[i] < 0);
  }
  ratio.rows = logs.size();
  if (!ratio.known()) return ratio;
  ratio.opposite /= static_cast<double>(logs.size());
  ratio.middle = record::median(logs);
  for (double& l : logs) l = std::abs(l - ratio.middle);
  ratio.spread = record::median(logs);
  ratio.correlation = correlation(a, b);
  return ratio;
}

/// At most so many rows, over all of the record.
Record some_of(const Record& data, std::size_t rows_wanted) {
  if (data.rows() <= rows_wanted) return data;
  std::vector<std::size_t> rows(data.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return data.picked(fit::thinned(std::move(rows), rows_wanted));
}

std::pair<double, double> range_of_values(std::span<const double> values) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const double v : values)
    if (std::isfinite(v)) lower = std::min(lower, v), upper = std::max(upper, v);
  return {lower, upper};
}

/// Temperatures that cannot be, or loads far above what the bearing carries.
bool has_impossible_input(const model::ModelSubject& subject, const Record& data) {
  const double rating = subject.model().bearing.static_load_rating();
  for (const record::Column& column : data.columns) {
    const auto [lower, upper] = range_of_values(column.values);
    if (record::is_temperature(*column.channel) && (lower < coldest || upper > hottest))
      return true;
    if (column.channel->kind == "load" && upper > 2.0 * rating) return true;
    if (column.channel->is_input() && lower < column.channel->to_SI(column.channel->lower) &&
        column.channel->kind != "load")
      return true;
  }
  return false;
}

/// Fit of a model whose free numbers were refitted to the readings.
struct Refitted {
  double error = unset;  ///< rms of the errors relative to the readings [1]
  double oddness = 0.0;  ///< of the numbers found: squared distance from those believed
  [[nodiscard]] bool known() const { return std::isfinite(error); }
};

/// Numbers of a law that people believe are right within this factor, one standard deviation; what
/// a model misses moves them less.
constexpr double usual_factor = 1.8;
constexpr std::size_t rows_of_refit = 80;

Refitted refitted(const model::ModelSubject& subject, const Record& data) {
  Refitted result;
  try {
    const auto record = std::make_shared<const Record>(some_of(data, rows_of_refit));
    const fit::Observations observed =
        fit::observe(subject.measured(), *record, fit::predict(subject, *record));
    if (static_cast<std::size_t>(observed.size()) < least_rows) return result;
    fit::Response response = fit::response_of(subject, record, observed, subject.free());
    response.find_affine_form();
    const double largest = observed.measured.cwiseAbs().maxCoeff();
    const Eigen::VectorXd size = observed.measured.cwiseAbs().cwiseMax(0.02 * largest);
    const fit::ResponseFit fit =
        fit::fit_response(response, fit::Whitening(size, {}, 0.0, 0.0), observed.measured,
                          {response.start(), 0.5 * response.start()});
    if (!fit.converged) return result;
    result.error = std::sqrt(fit.misfit / static_cast<double>(observed.size()));
    for (std::size_t k = 0; k < response.parameters.size(); ++k) {
      const double ratio =
          std::abs(fit.values[static_cast<Eigen::Index>(k)] / response.parameters[k].start);
      if (!(response.parameters[k].start > 0.0)) continue;
      const double far = std::log(std::clamp(ratio, 0.03, 30.0)) / std::log(usual_factor);
      result.oddness += far * far;
    }
  } catch (const std::invalid_argument&) {
    return {};  // the reader of the record reports it
  }
  return result;
}

/// Rows of a rig that lie beyond the friction table of its law.
std::ptrdiff_t beyond_table(const model::Model& model, const Record& data) {
  if (model.law != friction::FrictionLaw::table) return 0;
  const std::vector<model::Row> rows = model::rows_of(data);
  return std::count_if(rows.begin(), rows.end(), [&](const model::Row& row) {
    const friction::BearingState<> state = model::bearing_state(model, row.point, nullptr);
    return std::isfinite(state.axial_load) && !model.table->holds(state);
  });
}

/// By how much the readings speak for a column in another unit, as a difference of ln L: what the
/// refitted model errs less, and how much more usual its numbers are. What a model misses is alike
/// in neighbouring rows, so that many rows say no more than twenty.
double evidence_for(const model::ModelSubject& subject, const Record& as_read,
                    const Record& in_other) {
  constexpr double most_independent = 20.0, least_error = 0.01;
  constexpr double largest_error = 0.25;  // beyond it the model fits no unit
  // At its edge a table would fit the loads of any unit.
  if (beyond_table(subject.model(), in_other) > beyond_table(subject.model(), as_read))
    return -HUGE_VAL;
  const Refitted read = refitted(subject, as_read), other = refitted(subject, in_other);
  if (!read.known() || !(other.error < largest_error)) return -HUGE_VAL;
  const double rows = std::min(most_independent, static_cast<double>(as_read.rows()));
  return rows * std::log(std::max(read.error, least_error) / std::max(other.error, least_error)) +
         0.5 * (read.oddness - other.oddness);
}

struct NamedFactor {
  double factor, within;
  double most_spread;  ///< of a factor that other things may make as well
  std::string_view words;
  std::vector<Doubt::Guess> units;  ///< of columns that make the readings too small
};

/// "N m in a column of N mm" and what else makes a factor.
std::optional<Doubt> factor_of_readings(const model::ModelSubject& subject, const Ratio& ratio) {
  const Channel& channel = *subject.measured().front().channel;
  const bool moment = channel == record::friction_torque;
  const bool timed = moment && subject.expected().coast_down;  // torques may come from times
  const auto of_readings = [&](const char* unit, const char* of_time) {
    std::vector<Doubt::Guess> units{{&channel, unit}};
    if (timed) units.push_back({&record::time, of_time});
    return units;
  };
  const std::array factors{
      NamedFactor{1000.0, 5.0, 3.0,
                  timed    ? "are the values in N m instead of N mm, or in ms instead of s"
                  : moment ? "are the values in N m instead of N mm"
                           : "are the values in mm instead of um",
                  of_readings(moment ? "Nm" : "mm", "ms")},
      NamedFactor{
          1e6, 5.0, 3.0,
          moment ? "are the values in kN m instead of N mm" : "are the values in m instead of um",
          of_readings(moment ? "kNm" : "m", "us")},
      NamedFactor{10.0, 1.4, 1.4, "are the values in cN m instead of N mm", {{&channel, "cNm"}}},
      NamedFactor{60.0,
                  2.0,
                  1.4,
                  "are the values in min instead of s, or in 1/s instead of rpm",
                  {{&record::speed, "1_s"}, {&record::time, "min"}}},
      NamedFactor{9.7,
                  1.4,
                  1.4,
                  "are the values in kgf instead of N, or in rad/s instead of rpm",
                  {{&record::axial_load, "kgf"}, {&record::speed, "rad_s"}}}};
  if (!ratio.far() || (!moment && std::abs(ratio.correlation) < 0.9)) return std::nullopt;
  for (const NamedFactor& f : factors) {
    if (!ratio.near(f.factor, f.within) || ratio.spread > std::log(f.most_spread)) continue;
    if (!moment && f.factor < 100.0) continue;
    const bool small = ratio.middle < 0;
    // A torque in a larger unit is read as too small; inputs in a larger unit make it too large.
    if (timed ? f.factor == 10.0 : f.factor < 100.0 && small != (f.factor == 10.0)) continue;
    std::string text = fmt::format(
        "readings of {} are about {:.0f} times too {} for the model: {}?", channel.words,
        f.factor == 9.7 ? 10.0 : f.factor, small ? "small" : "large",
        small || f.factor < 100.0 ? std::string(f.words)
                                  : std::string("is the unit wrong, for example ") +
                                        (moment ? "N mm read as N m" : "um read as mm"));
    std::vector<Doubt::Guess> units = f.units;
    // Too large are readings that were in our unit and were read in a larger one.
    if (!small && f.factor >= 100.0) units = {{&channel, moment ? "Nmm" : "um"}};
    return Doubt{std::move(text), std::move(units)};
  }
  return std::nullopt;
}

std::optional<Doubt> sign_of_readings(const Channel& channel, const Ratio& ratio) {
  if (!ratio.known() || ratio.opposite < 0.9) return std::nullopt;
  // A zero that is off leaves readings that rise where they should.
  if (channel == record::friction_torque && !(ratio.correlation > 0.0))
    return Doubt{.text =
                     "readings of friction torque have the opposite sign: a torque against the "
                     "motion is positive",
                 .reversed = &channel};
  // The position may go the other way for reasons of its own, but then not in proportion.
  if (ratio.correlation > -0.95 || ratio.far()) return std::nullopt;
  return Doubt{
      fmt::format("readings of {} have the opposite sign ({}); set factor = -1 in [columns]",
                  channel.words, channel.direction)};
}

// Differences of ln L from which a unit is asked about. Few right records are as warm as a room in
// Fahrenheit throughout; one load in a hundred is in another unit.
constexpr double likely = -2.0, remarkable = 4.6;

std::optional<Doubt> unit_of_temperature(const model::ModelSubject& subject, const Record& data,
                                         const Channel& channel) {
  const auto [lower, upper] = range_of_values(data.values(channel));
  if (!(lower <= upper)) return std::nullopt;
  const double from = channel.in_unit(lower), to = channel.in_unit(upper);
  if (from > 220 && to < 470) return other_temperature(channel, from, to, "K");
  if (from < 59 || to > 400 || !(channel == record::temperature)) return std::nullopt;
  if (from > 150) return other_temperature(channel, from, to, "F");
  if (!data.has(record::friction_torque) || data.up_to_a_factor) return std::nullopt;
  // No row is as cold as a room, and the readings are those of oil that is colder.
  const Record other =
      in_other_unit(data, channel, *text::find_unit("F", text::Dimension::temperature));
  return evidence_for(subject, data, other) > likely
             ? std::optional(other_temperature(channel, from, to, "F"))
             : std::nullopt;
}

/// A speed in another unit, where the readings speak for it. The inertia makes torque of speed
/// where there are no readings, so then it is in their factor.
std::optional<Doubt> unit_of_speed(const model::ModelSubject& subject, const Record& data,
                                   const Ratio& ratio) {
  const double pitch = subject.model().bearing.pitch_diameter();
  const auto speed_factor = [&](double speed) { return speed / rpm * pitch / mm; };  // n d_m
  const double fastest = range_of_values(data.values(record::speed)).second;
  constexpr double never = 6e6, usual = 3e6;
  if (speed_factor(fastest) > never && speed_factor(fastest * rpm) < usual)
    return Doubt{fmt::format("speeds up to {:.4g} rpm are impossible for a bearing of this size (n "
                             "d_m = {:.2g} mm/min): are the values in rpm instead of rad/s or 1/s?",
                             fastest / rpm, speed_factor(fastest)),
                 {{&record::speed, "rpm"}}};
  if (!ratio.far()) return std::nullopt;
  for (const char* name : {"krpm", "1/s"}) {
    const text::Unit& unit = *text::find_unit(name, text::Dimension::speed);
    const Record changed = in_other_unit(data, record::speed, unit);
    if (speed_factor(range_of_values(changed.values(record::speed)).second) > usual) continue;
    const Ratio other = ratio_of(subject, changed);
    if (other.known() && std::abs(other.middle) < std::log(2.0))
      return Doubt{fmt::format("speeds up to {:.4g} rpm do not agree with the readings: are the "
                               "values in {} instead of rpm?",
                               fastest / rpm, unit.words),
                   {{&record::speed, unit.suffix}}};
  }
  return std::nullopt;
}

/// Error of the model as it stands, relative to the readings [1]; NaN where it has none.
double misfit(const model::ModelSubject& subject, const Record& data) {
  try {
    const std::vector<double> predicted = fit::predict(subject, data);
    const fit::Observations observed = fit::observe(subject.measured(), data, predicted);
    if (static_cast<std::size_t>(observed.size()) < least_rows) return unset;
    const std::vector<std::size_t> places = observed.places(data.rows());
    const double least = 0.02 * observed.measured.cwiseAbs().maxCoeff();
    double sum = 0.0;
    for (Eigen::Index i = 0; i < observed.size(); ++i) {
      const double read = observed.measured[i];
      const double off = predicted[places[static_cast<std::size_t>(i)]] - read;
      sum += off * off / std::max(read * read, least * least);
    }
    return std::sqrt(sum / static_cast<double>(observed.size()));
  } catch (const std::invalid_argument&) {
    return unset;  // the reader of the record reports it
  }
}

/// A load or a preload of a shaft in another unit, where the model as it stands errs far less.
std::optional<Doubt> unit_of_shaft_load(const model::ModelSubject& subject, const Record& data) {
  if (!subject.model().shaft || !data.has(record::axial_displacement)) return std::nullopt;
  const double mounted = subject.model().shaft->arrangement.preload();
  for (const Channel* channel : {&record::preload, &record::axial_load}) {
    if (!data.has(*channel)) continue;
    const auto [least, largest] = range_of_values(data.values(*channel));
    const bool is_preload = *channel == record::preload;
    // One external load for all rows says nothing of its size.
    if (!(largest > 0.0) || (!is_preload && !(largest > 1.02 * least))) continue;
    for (const char* name : {"kgf", "kN"}) {
      const text::Unit& unit = *text::find_unit(name, text::Dimension::force);
      const double middle = std::sqrt(std::max(least, 0.1 * largest) * largest);
      const auto off = [&](double load) { return std::abs(std::log(load / mounted)); };
      if (is_preload && mounted > 0.0 && !(off(unit.to_SI(middle)) < off(middle))) continue;
      // A refit has no number that moves with a preload which was recorded.
      constexpr double good = 0.25, far_better = 0.5;
      const double other = misfit(subject, in_other_unit(data, *channel, unit));
      if (!(other < good) || misfit(subject, data) < other / far_better) continue;
      return Doubt{
          fmt::format("{}s of {:.4g} to {:.4g} N do not agree with the readings, but {:.4g} to "
                      "{:.4g} N do: are the values in {} instead of N?",
                      channel->words, least, largest, unit.to_SI(least), unit.to_SI(largest), name),
          {{channel, unit.suffix}}};
    }
  }
  return std::nullopt;
}

/// Torques of a coast-down whose times are in another unit, where f0 and its like are far off too.
std::optional<Doubt> unit_of_coast_down(const model::ModelSubject& subject, const Record& data,
                                        const Ratio& ratio) {
  const record::Column* const std = data.deviation_of(record::friction_torque);
  if (!ratio.far() || !std || !std->known || !subject.expected().coast_down) return std::nullopt;
  double strongest = remarkable;
  const text::Unit* in_unit = nullptr;
  for (const char* name : {"min", "h", "ms"}) {
    const text::Unit& unit = *text::find_unit(name, text::Dimension::time);
    Record other = data;
    for (double& torque : other.find(record::friction_torque)->values) torque /= unit.factor;
    const double evidence = evidence_for(subject, data, other);
    if (!(evidence > strongest)) continue;
    strongest = evidence;
    in_unit = &unit;
  }
  if (!in_unit) return std::nullopt;
  return Doubt{fmt::format("readings of friction torque are about {:.2g} times too {} for the "
                           "model: are the times in {} instead of s?",
                           std::exp(std::abs(ratio.middle)), ratio.middle < 0 ? "small" : "large",
                           in_unit->words),
               {{&record::time, in_unit->suffix}}};
}

/// Loads that no bearing of this size is run with.
std::optional<Doubt> unit_of_load(const model::ModelSubject& subject, const Record& data) {
  const double rating = subject.model().bearing.static_load_rating();
  if (!(rating > 0) || subject.model().shaft) return std::nullopt;
  const double highest = range_of_values(data.values(record::axial_load)).second;
  const auto usual = [&](double load) { return load > 2e-3 * rating && load < 0.5 * rating; };
  // Our choice: no test of a bearing with C0 = 44 kN stays below 7 N, and 6 kN are a usual load.
  if (highest > 0 && highest < 1.5e-4 * rating && usual(1e3 * highest))
    return Doubt{fmt::format("axial loads up to {:.4g} N are very small for C0 = {:.4g} N: are the "
                             "values in kN instead of N?",
                             highest, rating),
                 {{&record::axial_load, "kN"}}};
  if (highest > 5.0 * rating && usual(1e-3 * highest))
    return Doubt{
        fmt::format(
            "axial loads up to {:.4g} N are {:.2g} times C0: are the values in N instead of kN?",
            highest, highest / rating),
        {{&record::axial_load, "N"}}};
  // A load in kilograms: the law makes up for it with numbers that no bearing has.
  const auto [least, largest] = range_of_values(data.values(record::axial_load));
  if (data.up_to_a_factor || !(largest > 1.02 * least)) return std::nullopt;
  const text::Unit& kgf = *text::find_unit("kgf", text::Dimension::force);
  if (evidence_for(subject, data, in_other_unit(data, record::axial_load, kgf)) > remarkable)
    return Doubt{fmt::format("axial loads of {:.4g} to {:.4g} N do not agree with the readings, "
                             "but {:.4g} to {:.4g} N do: are the values in kgf instead of N?",
                             least, largest, kgf.to_SI(least), kgf.to_SI(largest)),
                 {{&record::axial_load, "kgf"}}};
  return std::nullopt;
}

/// The record with two columns exchanged, in the numbers that stand in them; nothing where they
/// could not stand there.
std::optional<Record> exchanged(Record data, const Channel& a, const Channel& b) {
  std::vector<double>& first = data.find(a)->values;
  std::vector<double>& second = data.find(b)->values;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double of_a = a.in_unit(first[i]), of_b = b.in_unit(second[i]);
    if (of_b < a.lower || of_b > a.upper || of_a < b.lower || of_a > b.upper) return std::nullopt;
    first[i] = a.to_SI(of_b);
    second[i] = b.to_SI(of_a);
  }
  return data;
}

/// The smallest share of the variance that one of the subject's other base models leaves.
double unexplained_by_other_bases(const model::ModelSubject& subject, const Record& data) {
  double least = HUGE_VAL;
  for (const fit::OtherBase& base : subject.other_bases())
    if (const auto* const other = dynamic_cast<const model::ModelSubject*>(base.subject.get()))
      if (const Ratio ratio = ratio_of(*other, data); ratio.known())
        least = std::min(least, ratio.unexplained());
  return least;
}

std::optional<std::string> swapped_columns(const model::ModelSubject& subject, const Record& data,
                                           const Ratio& ratio) {
  const Channel& reading = *subject.measured().front().channel;
  // A column of zeros stands for one that nobody entered.
  const auto takes_part = [&](const Channel& c) {
    const auto [lower, upper] = range_of_values(data.values(c));
    return (c.is_input() || c == reading) && (lower != 0.0 || upper != 0.0);
  };
  const bool impossible = has_impossible_input(subject, data);
  // What a model misses bends readings, but not so that they fall into place once columns change.
  const bool scattered = ratio.known() && ratio.spread > std::log(1.2);
  if (!impossible && !ratio.far() && !scattered) return std::nullopt;
  std::optional<std::string> best;
  double left = HUGE_VAL;  // of the variance, by the best
  double least = impossible    ? std::log(3.0)
                 : ratio.far() ? 0.5 * ratio.spread
                               : std::min(0.5 * ratio.spread, std::log(1.2));
  for (std::size_t i = 0; i < data.columns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Channel &a = *data.columns[j].channel, &b = *data.columns[i].channel;
      if (!takes_part(a) || !takes_part(b)) continue;
      const auto changed = exchanged(data, a, b);
      if (!changed || has_impossible_input(subject, *changed)) continue;
      const Ratio other = ratio_of(subject, *changed);
      if (!other.known() || std::abs(other.middle) > std::log(2.0) || !(other.spread < least))
        continue;
      if (!impossible && !ratio.far() && other.unexplained() > 0.1 * ratio.unexplained()) continue;
      least = other.spread;
      left = other.unexplained();
      best = fmt::format(
          "columns {} and {} are probably swapped; correct the header of the file or [columns]",
          a.name, b.name);
    }
  // Another base law bends readings as far.
  if (best && !impossible && unexplained_by_other_bases(subject, data) <= left) return std::nullopt;
  return best;
}

/// The temperature of the model for all rows, where a ring was read at others.
std::optional<std::string> unused_temperature(const model::ModelSubject& subject,
                                              const Record& data) {
  constexpr double much = 5.0;  // [K]
  const auto defaults = subject.expected().defaults;
  const auto of_model = std::find_if(defaults.begin(), defaults.end(), [](const auto& d) {
    return *d.channel == record::temperature;
  });
  if (of_model == defaults.end() || std::isnan(of_model->value)) return std::nullopt;
  const auto [coolest, warmest] = range_of_values(data.values(record::temperature));
  if (coolest != of_model->value || warmest != of_model->value) return std::nullopt;
  for (const Channel* ring : {&record::outer_ring_temperature, &record::inner_ring_temperature}) {
    if (!data.has(*ring)) continue;
    const auto [lower, upper] = range_of_values(data.values(*ring));
    if (!(std::max(std::abs(lower - coolest), std::abs(upper - coolest)) > much)) continue;
    return fmt::format(
        "all rows use the viscosity at {0:.4g} C, from {1}, but {2} goes from {3:.4g} to {4:.4g} "
        "C: if {2} is the temperature of the lubricant, name its column {5}",
        record::temperature.in_unit(coolest), of_model->from, ring->name, ring->in_unit(lower),
        ring->in_unit(upper), record::temperature.name);
  }
  return std::nullopt;
}

}  // namespace

std::vector<Doubt> doubts(const model::ModelSubject& subject, const Record& all) {
  std::vector<Doubt> found;
  const auto add = [&](std::optional<Doubt> doubt) {
    if (doubt) found.push_back(*std::move(doubt));
  };
  const auto add_text = [&](std::optional<std::string> text) {
    if (text) found.push_back({*std::move(text)});
  };
  if (subject.measured().empty() || !all.has(*subject.measured().front().channel)) return found;
  const Record data = some_of(all, most_rows);
  const Channel& channel = *subject.measured().front().channel;
  // With an unknown inertia the readings have any factor.
  const Ratio ratio = data.up_to_a_factor ? Ratio{} : ratio_of(subject, data);
  for (const record::Column& column : data.columns)
    if (record::is_temperature(*column.channel))
      add(unit_of_temperature(subject, data, *column.channel));
  if (found.empty()) add(unit_of_shaft_load(subject, data));
  if (found.empty() && !data.up_to_a_factor) add_text(swapped_columns(subject, data, ratio));
  if (found.empty()) add(unit_of_load(subject, data));
  if (found.empty()) {
    add(unit_of_coast_down(subject, data, ratio));
    if (found.empty()) add(factor_of_readings(subject, ratio));
    if (found.empty() && !subject.model().shaft) add(unit_of_speed(subject, data, ratio));
  }
  add(sign_of_readings(channel, ratio));
  add_text(unused_temperature(subject, data));
  return found;
}

}  // namespace raceway::files
