#include "correction/baseline.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "algebra/detail/decompositions.h"
#include "correction/correction_subject.h"
#include "correction/numbers.h"
#include "correction/range.h"
#include "correction/regression.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "fit/thinned.h"
#include "record/series_channel.h"
#include "verdict/compare.h"

namespace raceway::correction {

std::vector<DrivenChannel> bare_channels(const Model& model,
                                         const std::vector<const Channel*>& offered,
                                         std::vector<record::Note>& messages) {
  std::vector<DrivenChannel> list;
  for (const DrivenChannel& c : model.channels) {
    if (c.input.is_power())
      messages.push_back(record::note::rows_used(
          fmt::format("channel {} is left out: a regression uses only columns of the record, but "
                      "the input of this channel is a calculated power",
                      c.name),
          {.key = c.name}));
    else
      list.push_back({.name = c.name, .input = c.input});
  }
  for (const Channel* column : offered) {
    const auto drives = [&](const DrivenChannel& c) {
      return c.input.columns == std::vector{column} && !c.input.reference;
    };
    if (std::any_of(list.begin(), list.end(), drives)) continue;
    list.push_back({.name = std::string(column->variable),
                    .input = {.name = std::string(column->name), .columns = {column}}});
  }
  if (list.empty())
    throw std::invalid_argument(
        "no channel of the model has a column as input, and --inputs names no column");
  return list;
}

namespace {

/// Columns of a regression: of every channel, then the zero of every run.
class Design {
 public:
  Design(const Series& series, std::span<const double> readings) : series_(series) {
    for (std::size_t k = 0; k < readings.size(); ++k)
      if (std::isfinite(readings[k])) rows_.push_back(k);
    y_.resize(static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      y_[static_cast<Eigen::Index>(i)] = readings[rows_[i]] / um;
    columns_ = Eigen::MatrixXd::Zero(y_.size(), series.zeros());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      columns_(static_cast<Eigen::Index>(i), series.zero()[rows_[i]]) = 1.0;
  }

  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }
  [[nodiscard]] const Eigen::MatrixXd& columns() const { return columns_; }
  [[nodiscard]] const Eigen::VectorXd& y() const { return y_; }

  /// False for one that says nothing beyond the others.
  bool add(const Input& input) {
    const Series::Values values = series_.at_once(input);
    Eigen::MatrixXd with(columns_.rows(), columns_.cols() + 1);
    with << columns_, Eigen::VectorXd(columns_.rows());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      with(static_cast<Eigen::Index>(i), columns_.cols()) = (*values)[rows_[i]] / input.factor();
    if (!is_new(with)) return false;
    columns_ = std::move(with);
    return true;
  }

 private:
  /// Some rows are enough to see that.
  [[nodiscard]] bool is_new(const Eigen::MatrixXd& with) const {
    constexpr std::size_t enough = 5000;
    constexpr double too_little = 1e-6;  // of its length
    std::vector<std::size_t> all(rows_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const std::vector<std::size_t> some = fit::thinned(std::move(all), enough);
    Eigen::MatrixXd part(static_cast<Eigen::Index>(some.size()), with.cols());
    for (std::size_t i = 0; i < some.size(); ++i)
      part.row(static_cast<Eigen::Index>(i)) = with.row(static_cast<Eigen::Index>(some[i]));
    const Eigen::VectorXd last = part.col(part.cols() - 1);
    const Eigen::MatrixXd others = part.leftCols(part.cols() - 1);
    const Eigen::VectorXd left = last - others * algebra::least_squares(others, last);
    return left.norm() > too_little * last.norm();
  }

  const Series& series_;
  std::vector<std::size_t> rows_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd y_;
};

/// RMS over parts of which each is predicted from the others [um].
double error_held_out(const Design& design, const CorrectionSubject& subject,
                      const record::Record& record) {
  const std::vector<fit::Blocking> blockings = subject.blockings(record);
  if (blockings.empty()) return unset;
  double square = 0.0;
  Eigen::Index count = 0;
  for (int block = 0; block < blockings.front().blocks; ++block) {
    std::vector<Eigen::Index> out, in;
    for (std::size_t i = 0; i < design.rows().size(); ++i)
      (blockings.front().block[design.rows()[i]] == block ? out : in)
          .push_back(static_cast<Eigen::Index>(i));
    if (out.empty() || static_cast<Eigen::Index>(in.size()) < design.columns().cols()) continue;
    // A run that lies within one part has its zero there alone: it is left at the least norm.
    const Eigen::VectorXd found =
        algebra::minimum_norm_solution(design.columns()(in, Eigen::all), design.y()(in));
    const Eigen::VectorXd left =
        design.y()(out) - Eigen::MatrixXd(design.columns()(out, Eigen::all)) * found;
    square += left.squaredNorm();
    count += left.size();
  }
  return count > 0 ? std::sqrt(square / static_cast<double>(count)) : unset;
}

record::Parameter coefficient(const std::string& name, const std::string& unit, double value,
                              double std) {
  record::Parameter p;
  p.name = name;
  p.unit = unit;
  p.start = 0.0;
  p.value = value;
  p.std = std;
  return p;
}

}  // namespace

Identification regression_baseline(const Model& model, const std::vector<const Channel*>& offered,
                                   const record::Record& record) {
  Identification result;
  Model found = model;
  found.kinematic.reset();
  found.effects.clear();
  found.covariance.reset();
  found.channels.clear();
  found.free.clear();
  found.initial_state = InitialState::rest;  // it has no state
  const Series series(record);
  Design design(series, record.values(*model.displacement));
  for (DrivenChannel& c : bare_channels(model, offered, result.messages)) {
    if (design.add(c.input))
      found.channels.push_back(std::move(c));
    else
      result.messages.push_back(
          record::note::rows_used(fmt::format("channel {} is left out: its input is constant or a "
                                              "linear combination of the other inputs",
                                              c.name),
                                  {.key = c.name}));
  }
  if (found.channels.empty()) throw std::invalid_argument("no input varies");
  if (design.y().size() < 3 * design.columns().cols())
    throw std::invalid_argument(
        fmt::format("{} readings of {} are too few for {} parameters: a fit needs three or more "
                    "for each parameter",
                    design.y().size(), model.displacement->words, design.columns().cols()));
  const Regression fit = regress(design.columns(), design.y());
  const Eigen::Index zeros = series.zeros();
  found.offset = fit.coefficients[0] * um;
  for (std::size_t c = 0; c < found.channels.size(); ++c)
    found.channels[c].feedthrough = fit.coefficients[zeros + static_cast<Eigen::Index>(c)] * um /
                                    found.channels[c].input.factor();
  const Eigen::VectorXd simulated = design.columns() * fit.coefficients;
  std::vector<double> predicted(record.rows(), unset);
  for (std::size_t i = 0; i < design.rows().size(); ++i)
    predicted[design.rows()[i]] = simulated[static_cast<Eigen::Index>(i)] * um;
  const CorrectionSubject subject(found);
  const verdict::Comparison c = verdict::compare(predicted, record, subject.measured().front());
  result.metrics = metrics(record.values(*model.displacement), predicted);
  result.rms_held_out = error_held_out(design, subject, record) * um;
  result.condition = fit.condition;
  result.correlation_time = c.correlation_time;
  result.noise = c.noise.rms;
  result.noise_source = c.noise.source;
  // Of rows that follow each other only one in so many counts.
  const std::span<const double> time = record.values(record::time);
  const double spacing = (time[design.rows().back()] - time[design.rows().front()]) /
                         static_cast<double>(design.rows().size() - 1);
  const double alike =
      std::isfinite(c.correlation_time) ? 1.0 + 2.0 * c.correlation_time / spacing : 1.0;
  const double freedom = static_cast<double>(design.y().size() - design.columns().cols());
  const double variance = (design.y() - simulated).squaredNorm() / freedom * alike;
  const Eigen::MatrixXd inverse =
      algebra::symmetric_inverse(design.columns().transpose() * design.columns());
  const auto std_of = [&](Eigen::Index k) { return std::sqrt(variance * inverse(k, k)); };
  result.parameters.push_back(
      coefficient("offset", std::string(unit_of(found)), fit.coefficients[0], std_of(0)));
  StructureTried tried{.rms_held_out = result.rms_held_out, .rms = fit.rms * um, .taken = true};
  for (std::size_t k = 0; k < found.channels.size(); ++k) {
    const Eigen::Index at = zeros + static_cast<Eigen::Index>(k);
    const DrivenChannel& channel = found.channels[k];
    result.parameters.push_back(coefficient(
        channel.name + ".feedthrough", in_unit_of(found, "um/" + std::string(channel.input.unit())),
        fit.coefficients[at], std_of(at)));
    tried.channels.push_back(channel.name);
    tried.orders.push_back(0);
  }
  result.tried = {std::move(tried)};
  see(found, record);
  found.evidence = evidence_on(found, record, result.rms_held_out);
  result.model = std::move(found);
  result.messages.push_back(
      record::note::limits("a regression predicts each row from the inputs of this row only, and "
                           "extrapolates linearly"));
  return result;
}

bool is_regression(const Model& model) {
  const auto is_bare = [](const DrivenChannel& c) {
    return c.sections.empty() && !c.element && !c.printed && !c.input.is_power();
  };
  return !model.channels.empty() && !model.kinematic && model.effects.empty() &&
         std::all_of(model.channels.begin(), model.channels.end(), is_bare);
}

}  // namespace raceway::correction
