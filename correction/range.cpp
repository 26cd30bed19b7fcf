#include "correction/range.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/detail/decompositions.h"
#include "correction/correction_subject.h"
#include "correction/numbers.h"
#include "correction/quantum.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double apart = 0.01;       // that correlations are kept from 1 and -1
constexpr double rounding = 1e-9;    // of a range as it is written
constexpr double same_cloud = 1e-4;  // of a distance

/// Speeds and feeds act by their amount, all else as it stands.
double acting(const Channel& column, double value) {
  return record::acts_by_amount(column) ? std::abs(value) : value;
}

Interval acting(const SeenRange& r) {
  if (!r.column || !record::acts_by_amount(*r.column) || r.lower >= 0.0) return {r.lower, r.upper};
  return {0.0, std::max(-r.lower, r.upper)};
}

bool within(const Interval& seen, double value) {
  const double slack = rounding * std::max(std::abs(seen.lower), std::abs(seen.upper));
  return value >= seen.lower - slack && value <= seen.upper + slack;
}

std::vector<double> acting_values(const record::Record& record, const Channel& column) {
  std::vector<double> list;
  for (const double v : record.values(column)) list.push_back(acting(column, v));
  return list;
}

SeenRange range_of(const Channel* column, std::string name, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {.column = column, .name = std::move(name), .lower = *low, .upper = *high};
}

/// Rows of the inputs of a cloud.
class Points {
 public:
  Points(const std::vector<const Channel*>& columns, const record::Record& record) {
    for (const Channel* c : columns) values_.push_back(acting_values(record, *c));
  }
  [[nodiscard]] bool complete(std::size_t rows) const {
    return std::all_of(values_.begin(), values_.end(),
                       [&](const auto& column) { return column.size() == rows; });
  }
  [[nodiscard]] Eigen::VectorXd at(std::size_t row) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(values_.size()));
    for (std::size_t c = 0; c < values_.size(); ++c)
      x[static_cast<Eigen::Index>(c)] = values_[c][row];
    return x;
  }

 private:
  std::vector<std::vector<double>> values_;
};

std::optional<SeenTogether> together_on(const Model& model, const record::Record& record) {
  SeenTogether seen;
  for (const Channel* c : inputs_of(model)) {
    const std::vector<double> v = acting_values(record, *c);
    if (v.empty() || !std::isfinite(v.front())) continue;
    if (std::any_of(v.begin(), v.end(), [&](double x) { return x != v.front(); }))
      seen.columns.push_back(c);
  }
  const std::size_t rows = record.rows();
  if (seen.columns.size() < 2) return std::nullopt;  // the range of one says it all
  const Points points(seen.columns, record);
  const auto count = static_cast<Eigen::Index>(seen.columns.size());
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows), count);
  for (std::size_t k = 0; k < rows; ++k)
    all.row(static_cast<Eigen::Index>(k)) = points.at(k).transpose();
  seen.mean = all.colwise().mean();
  const Eigen::MatrixXd centred = all.rowwise() - seen.mean.transpose();
  const Eigen::MatrixXd covariance = centred.transpose() * centred / static_cast<double>(rows);
  seen.std = covariance.diagonal().cwiseSqrt();
  if (!seen.std.allFinite() || !(seen.std.minCoeff() > 0.0)) return std::nullopt;
  const Eigen::VectorXd scale = seen.std.cwiseInverse();
  seen.correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
  seen.correlation.diagonal().setOnes();
  const Distance distance(seen);
  seen.farthest = 0.0;
  for (std::size_t k = 0; k < rows; ++k)
    seen.farthest = std::max(seen.farthest, distance(points.at(k)));
  return seen;
}

record::Record up_to_last_reading(const record::Record& record, const Channel& displacement) {
  const std::span<const double> read = record.values(displacement);
  std::vector<std::size_t> rows(record.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  while (!rows.empty() && !read.empty() && std::isnan(read[rows.back()])) rows.pop_back();
  return rows.empty() || rows.size() == record.rows() ? record : record.picked(rows);
}

/// Notes one value after the other.
class Watch {
 public:
  Watch(Beyond::Part part, Beyond& into) : part_(std::move(part)), into_(into) {}
  void see(std::size_t row, double value, bool inside) {
    if (inside || !std::isfinite(value)) return;
    if (part_.rows++ == 0) {
      part_.first = row;
      part_.value = part_.farthest = value;
    }
    const double middle = 0.5 * (part_.lower + part_.upper);
    if (std::abs(value - middle) > std::abs(part_.farthest - middle)) part_.farthest = value;
    into_.at_row[row] = true;
  }
  void done() {
    if (part_.rows > 0) into_.parts.push_back(std::move(part_));
  }

 private:
  Beyond::Part part_;
  Beyond& into_;
};

/// All columns held in their ranges and drawn to what they were together.
record::Record held_within(const Model& model, const record::Record& record) {
  record::Record held = record;
  for (const SeenRange& r : model.range) {
    record::Column* const column = r.column ? held.find(*r.column) : nullptr;
    if (!column) continue;
    const Interval seen = acting(r);
    for (double& v : column->values)
      if (std::isfinite(v)) v = std::clamp(acting(*r.column, v), seen.lower, seen.upper);
  }
  if (!model.together) return held;
  const SeenTogether& seen = *model.together;
  const Points points(seen.columns, held);
  if (!points.complete(held.rows())) return held;
  const Distance distance(seen);
  for (std::size_t k = 0; k < held.rows(); ++k) {
    const Eigen::VectorXd x = points.at(k);
    const double d = distance(x);
    if (!(d > seen.farthest)) continue;
    const Eigen::VectorXd nearer = seen.mean + (x - seen.mean) * (seen.farthest / d);
    for (std::size_t c = 0; c < seen.columns.size(); ++c)
      held.find(*seen.columns[c])->values[k] = nearer[static_cast<Eigen::Index>(c)];
  }
  return held;
}

}  // namespace

Distance::Distance(const SeenTogether& seen) : mean_(seen.mean), std_(seen.std) {
  const auto size = seen.correlation.rows();
  weights_ =
      algebra::inverse_lower_root(seen.correlation + apart * Eigen::MatrixXd::Identity(size, size));
}

double Distance::operator()(const Eigen::VectorXd& x) const {
  return (weights_ * (x - mean_).cwiseQuotient(std_)).norm();
}

void forget_what_was_seen(Model& model) {
  model.range.clear();
  model.together.reset();
  model.covariance.reset();
  model.left.reset();
  model.evidence.reset();
}

void see(Model& model, const record::Record& whole) {
  const record::Record record = up_to_last_reading(whole, *model.displacement);
  model.range.clear();
  for (const Channel* c : inputs_of(model)) {
    if (!record.has(*c)) continue;
    model.range.push_back(range_of(c, std::string(c->name), acting_values(record, *c)));
    if (record::is_temperature(*c))
      model.range.back().still = longest_still(record, record.values(*c)).longest;
  }
  const Series series(record);
  for (const DrivenChannel& c : model.channels)
    if (c.input.is_power())
      model.range.push_back(range_of(nullptr, c.name, *series.input(c.input)));
  model.together = together_on(model, record);
}

Model trusted(const verdict::Calibration& found, const record::Record& record) {
  Model model = model_of(*found.subject);
  see(model, record);
  model.left = Left{.rms = std::isfinite(found.rms_held_out) ? found.rms_held_out
                                                             : found.channels.front().rmse_after,
                    .correlation_time = found.correlation_time};
  model.evidence = evidence_on(model, record, found.rms_held_out);
  const std::optional<fit::Covariance> all = verdict::covariance_of(found);
  if (!all) return model;
  // Zeros and first states of that record are no numbers of the model.
  const std::vector<record::Parameter> own = parameters(model);
  fit::Covariance c;
  std::vector<Eigen::Index> places;
  for (std::size_t k = 0; k < all->names.size(); ++k)
    if (std::any_of(own.begin(), own.end(),
                    [&](const record::Parameter& p) { return p.name == all->names[k]; })) {
      c.names.push_back(all->names[k]);
      places.push_back(static_cast<Eigen::Index>(k));
    }
  if (places.empty()) return model;
  c.values = all->values(places);
  c.matrix = all->matrix(places, places);
  model.covariance = std::move(c);
  return model;
}

Interval seen_of(const Model& model, const Channel& column) {
  for (const SeenRange& r : model.range)
    if (r.column && *r.column == column) return acting(r);
  return {};
}

Interval seen_speed(const Model& model) {
  const Interval seen = seen_of(model, record::speed);
  return {seen.lower / rpm, seen.upper / rpm};
}

Interval seen_power(const Model& model, const DrivenChannel& channel) {
  for (const SeenRange& r : model.range)
    if (!r.column && r.name == channel.name) return {r.lower, r.upper};
  return {};
}

Interval seen_by_element(const Model& model, const DrivenChannel& channel) {
  if (channel.input.is_power()) return seen_power(model, channel);
  if (channel.input.columns.size() != 1) return {};
  const double unit = channel.input.factor();
  const Interval seen = seen_of(model, *channel.input.columns.front());
  return {seen.lower / unit, seen.upper / unit};
}

std::size_t Beyond::rows() const {
  return static_cast<std::size_t>(std::count(at_row.begin(), at_row.end(), true));
}

Beyond beyond_range(const Model& model, const Series& series) {
  const record::Record& record = series.record();
  Beyond result{.at_row = std::vector<bool>(record.rows(), false), .known = !model.range.empty()};
  for (const SeenRange& r : model.range) {
    const Interval seen = acting(r);
    Watch watch({.column = r.column, .name = r.name, .lower = seen.lower, .upper = seen.upper},
                result);
    std::vector<double> values;
    if (r.column)
      values = acting_values(record, *r.column);
    else if (const DrivenChannel* const of = find_channel(model, r.name);
             of && of->input.is_power())
      values = *series.input(of->input);
    for (std::size_t k = 0; k < values.size(); ++k)
      watch.see(k, values[k], within(seen, values[k]));
    watch.done();
  }
  if (!model.together) return result;
  const Points points(model.together->columns, record);
  if (!points.complete(record.rows())) return result;
  const Distance distance(*model.together);
  const double limit = model.together->farthest;
  Watch watch({.lower = 0.0, .upper = limit}, result);
  for (std::size_t k = 0; k < record.rows(); ++k) {
    const double d = distance(points.at(k));
    watch.see(k, d, d <= limit * (1.0 + same_cloud));
  }
  watch.done();
  return result;
}

std::vector<double> extrapolated(const Model& model, const Series& series, const Beyond& beyond) {
  std::vector<double> size(series.rows(), 0.0);
  if (beyond.parts.empty()) return size;
  const record::Record record = held_within(model, series.record());
  Model held = model;
  for (DrivenChannel& c : held.channels)
    if (c.input.is_power()) c.input.within = seen_power(model, c);
  const Series at_edge(record);
  const std::vector<Contribution> as_is = contributions(model, series),
                                  within_range = contributions(held, at_edge);
  for (std::size_t p = 0; p < as_is.size(); ++p)
    for (std::size_t k = 0; k < size.size(); ++k)
      size[k] += std::abs(as_is[p].displacement[k] - within_range[p].displacement[k]);
  return size;
}

}  // namespace raceway::correction
