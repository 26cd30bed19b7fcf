#include "fit/noise_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fit/detail/noise_search.h"
#include "fit/dwells.h"
#include "record/levels.h"
#include "record/repeats.h"

namespace raceway::fit {

namespace {

constexpr double wide_sweep = 1.5;  // over which growth can be seen
constexpr std::size_t most_levels_of_noise = 24;

/// The values of a column at these rows, where all are above zero and the largest is by a factor
/// above the smallest; otherwise none.
Eigen::VectorXd positive(std::span<const double> column, std::span<const std::size_t> rows,
                         double factor) {
  if (column.empty() || rows.empty()) return {};
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = column[rows[i]];
  const bool all = values.allFinite() && (values.array() > 0.0).all();
  return all && values.maxCoeff() > factor * values.minCoeff() ? values : Eigen::VectorXd();
}

/// The level of each reading on a setting, where it stands at some few.
void add_levels(const record::Column& column, std::span<const std::size_t> rows,
                std::vector<std::vector<std::size_t>>& levels) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(column.values[row]);
  const std::vector<double> starts =
      record::level_starts(values, record::step_of(*column.channel, values));
  if (starts.size() < 2 || starts.size() > most_levels_of_noise) return;
  std::vector<std::size_t>& own = levels.emplace_back();
  for (const double value : values) own.push_back(record::level_of(value, starts));
}

}  // namespace

void NoiseModel::scale(double factor) {
  for (double* const size : {&relative, &absolute, &input, &run_unit, &rms}) *size *= factor;
  whitening = whitening.scaled(factor);
  for (Whitening& other : allowed) other = other.scaled(factor);
}

double NoiseModel::run_offset() const {
  return std::sqrt(run_share) * (run_unit > 0.0 ? run_unit : rms);
}

double NoiseModel::growth_at(const Record& record, std::size_t row) const {
  return growth > 0.0 ? std::pow(record.value(*swept, row) / largest_swept, growth) : 1.0;
}

ChannelReadings readings_of(const Record& record, const Observations& observed,
                            std::size_t channel) {
  const std::span<const std::size_t> rows = observed.rows(channel);
  ChannelReadings result{.measured = observed.of(channel, observed.measured)};
  if (const record::Column* const std = record.deviation_of(*observed.channels[channel].channel)) {
    result.std.resize(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.std[static_cast<Eigen::Index>(i)] = std->values[rows[i]];
    if (!result.std.allFinite() || !(result.std.array() > 0.0).all()) result.std.resize(0);
    result.known = std->known && result.std.size() > 0;
  }
  result.within = positive(record.values(dwell_scatter), rows, 0.0);
  for (const record::Column& column : record.columns) {
    if (column.channel->role != record::Role::setting || !column.channel->ratio) continue;
    add_levels(column, rows, result.levels);
    if (result.swept_by) continue;
    result.swept = positive(column.values, rows, wide_sweep);
    if (result.swept.size() > 0) result.swept_by = column.channel;
  }
  result.order = row_order(record, rows);
  if (!record.parts.empty())
    for (const std::size_t row : rows) result.part.push_back(record.part_of(row));
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = i;
  for (record::RepeatGroup group : record::find_repeats(record, {}, rows)) {
    for (std::size_t& member : group) member = place.at(member);
    result.repeats.push_back(std::move(group));
  }
  return result;
}

NoiseModel known_noise_model(const ChannelReadings& readings) {
  NoiseModel noise;
  noise.rms = noise.absolute = fit::rms(readings.std);
  noise.degrees_of_freedom = NoiseSearch::as_good_as_known;
  noise.whitening = Whitening(readings.std, {}, 0.0, 0.0);
  return noise;
}

Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                       const Eigen::VectorXd& size) {
  if (readings.known) return known_noise_model(readings).whitening;
  Eigen::VectorXd own = Eigen::VectorXd::Ones(size.size());
  if (readings.std.size() > 0)
    own = readings.std / fit::rms(readings.std);
  else if (readings.within.size() > 0)
    own = readings.within / fit::rms(readings.within);
  Eigen::VectorXd relative = noise.relative * size;
  if (noise.growth > 0.0)
    relative.array() *= (readings.swept.array() / noise.largest_swept).pow(noise.growth);
  Eigen::VectorXd std =
      (relative.array().square() + (noise.absolute * own).array().square()).sqrt();
  if (!noise.records.empty())
    for (Eigen::Index i = 0; i < std.size(); ++i)
      std[i] *= noise.records.at(readings.part.at(static_cast<std::size_t>(i)));
  // The correlation belongs to the step of the readings that it was found in.
  const double steps = readings.order.median_step / noise.median_step;
  const double correlation = noise.correlation > 0.0 ? std::pow(noise.correlation, steps) : 0.0;
  return {std, readings.order, correlation, noise.run_share, noise.state_share, {}, noise.run_unit};
}

double beyond_noise(double error, double noise) {
  return std::sqrt(std::max(0.0, error * error - noise * noise));
}

void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error) {
  if (!(error > 0.0)) return;
  const Eigen::VectorXd std =
      (noise.whitening.std().array().square() + error * error).sqrt().matrix();
  noise.whitening = Whitening(std, readings.order, noise.correlation, noise.run_share,
                              noise.state_share, {}, noise.run_unit);
  noise.absolute = std::hypot(noise.absolute, error);
  noise.rms = std::hypot(noise.rms, error);
}

NoiseModel estimate_noise_model(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& size, const NoiseOptions& options) {
  return NoiseSearch(readings, columns, size, options).run();
}

}  // namespace raceway::fit
