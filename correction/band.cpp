#include "correction/band.h"

#include <algorithm>
#include <cmath>

#include "algebra/detail/decompositions.h"
#include "correction/numbers.h"
#include "correction/quantum.h"
#include "correction/simulation.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double two_sided = 1.959963984540;  // of a normal law, 95 %
constexpr double step_share = 0.1;            // of a standard error
constexpr double share_of_a_lag = 0.1;        // by which no time constant is moved more
constexpr double nothing = 1e-14;             // of the largest axis

/// How far one may go along a direction without leaving what the numbers can be.
double step_along(const Eigen::VectorXd& direction, const std::vector<record::Parameter>& of) {
  double step = step_share;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const double by = std::abs(direction[static_cast<Eigen::Index>(k)]);
    if (!(by > 0.0)) continue;
    const double value = of[k].value;
    if (of[k].unit == "s" && value > 0.0)
      step = std::min(step, share_of_a_lag * value / by);
    else if (const double room = std::min(value - of[k].lower, of[k].upper - value);
             std::isfinite(room) && room > 0.0)
      step = std::min(step, room / by);
  }
  return step;
}

std::vector<double> of_beginning(const Model& model, const Series& series) {
  std::vector<double> sum(series.rows(), 0.0), as_is(series.rows()), moved(series.rows());
  const record::Record& record = series.record();
  simulate(model, series, as_is);
  for (const Channel* column : inputs_of(model)) {
    if (!record::is_temperature(*column)) continue;
    const double quantum = quantum_of(*column, record.values(*column));
    if (!std::isfinite(quantum)) continue;
    record::Record other = record;
    std::vector<double>& values = other.find(*column)->values;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (series.clock().begins[k]) values[k] += quantum;
    simulate(model, Series(other), moved);
    constexpr double evenly_spread = 1.0 / 12.0;  // variance over the square of the width
    constexpr double records = 2.0;
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += records * evenly_spread * std::pow(moved[k] - as_is[k], 2);
  }
  for (double& v : sum) v = std::sqrt(v);
  return sum;
}

}  // namespace

std::vector<double> Band::half_width() const {
  std::vector<double> half(of_numbers.size());
  for (std::size_t k = 0; k < half.size(); ++k)
    half[k] =
        two_sided * std::hypot(of_numbers[k], of_beginning[k], of_what_is_left) + extrapolated[k];
  return half;
}

Band band_of(const CorrectionSubject& subject, const Model& model,
             const std::shared_ptr<const Series>& series, const Beyond& beyond) {
  Band band{.of_numbers = std::vector<double>(series->rows(), 0.0),
            .of_beginning = of_beginning(subject.model(), *series),
            .of_what_is_left = model.left ? model.left->rms : 0.0,
            .extrapolated = correction::extrapolated(model, *series, beyond)};
  if (!model.covariance) return band;
  const fit::Covariance& c = *model.covariance;
  std::vector<std::string> names;
  std::vector<Eigen::Index> places;
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    if (model.initial_state == InitialState::free && c.names[k] == "offset") continue;
    names.push_back(c.names[k]);
    places.push_back(static_cast<Eigen::Index>(k));
  }
  if (names.empty()) return band;
  std::vector<record::Parameter> of;
  for (const std::string& name : names)
    for (record::Parameter& p : parameters(model))
      if (p.name == name) of.push_back(std::move(p));
  // Along the axes of the numbers over their standard errors: what cancels between two of them
  // cancels before it is a difference of large ones.
  const Eigen::MatrixXd matrix = c.matrix(places, places);
  const Eigen::VectorXd std = matrix.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd scale = std.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 0.0; });
  const algebra::SymmetricEigen axes =
      algebra::symmetric_eigen(scale.asDiagonal() * matrix * scale.asDiagonal());
  const auto predictor = subject.predictor(series->record(), names, series);
  const Eigen::VectorXd here = c.values(places);
  std::vector<double> above(series->rows()), below(series->rows());
  for (Eigen::Index j = 0; j < here.size(); ++j) {
    const double size = axes.values[j];
    if (!(size > nothing * axes.values.maxCoeff())) continue;
    const Eigen::VectorXd direction = std::sqrt(size) * std.cwiseProduct(axes.vectors.col(j));
    const double step = step_along(direction, of);
    const auto at = [&](double by, std::vector<double>& out) {
      const Eigen::VectorXd values = here + by * direction;
      predictor->readings({values.data(), static_cast<std::size_t>(values.size())}, out);
    };
    at(step, above);
    at(-step, below);
    for (std::size_t k = 0; k < above.size(); ++k)
      band.of_numbers[k] += std::pow((above[k] - below[k]) / (2.0 * step), 2);
  }
  for (double& v : band.of_numbers) v = std::sqrt(v);
  return band;
}

}  // namespace raceway::correction
