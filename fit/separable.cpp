#include "fit/separable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "fit/least_squares.h"
#include "fit/noise.h"

namespace raceway::fit {
namespace {

constexpr int most_tries = 60;
constexpr double small_step = 1e-6;      // of a derivative, on the scale of a parameter
constexpr double settled_misfit = 1e-9;  // relative fall of the misfit that is none
constexpr double decade = 10.0;

bool is_logarithmic(const Parameter& p) {
  return p.lower > 0.0 && std::isfinite(p.upper) && p.upper > decade * p.lower;
}

}  // namespace

double tolerance_of(const Measured& measured, const Record& record) {
  if (std::isfinite(measured.tolerance) || !measured.approximate) return measured.tolerance;
  if (!(measured.model_error > 0.0)) return unset;
  const double noise =
      std::isfinite(measured.std) ? measured.std : noise_of_neighbours(record, *measured.channel);
  return std::isfinite(noise) ? std::hypot(measured.model_error, noise) : measured.model_error;
}

Means means_of(const Subject& subject, const Record& record, double width) {
  Means means;
  const std::vector<Blocking> blockings = subject.blockings(record);
  const std::span<const double> time = record.values(record::time);
  const std::vector<Measured> channels = subject.measured();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::span<const double> read = record.values(*channels[c].channel);
    if (read.empty()) continue;
    const double tolerance = tolerance_of(channels[c], record);
    const double weight = 1.0 / (std::isfinite(tolerance) ? tolerance : 1.0);
    std::map<std::tuple<int, int, long>, std::size_t> places;
    for (std::size_t k = 0; k < read.size(); ++k) {
      if (!std::isfinite(read[k])) continue;
      const int block = blockings.empty() ? -1 : blockings.front().block[k];
      const auto place = static_cast<Eigen::Index>(c * record.rows() + k);
      const long bin =
          width > 0.0 ? std::lround(std::floor((time[k] - time[0]) / width)) : static_cast<long>(k);
      const auto [found, is_new] =
          places.emplace(std::tuple(record.run_of(k), block, bin), means.list.size());
      if (is_new)
        means.list.push_back(
            {.measured = 0.0, .channel = c, .weight = weight, .time = 0.0, .block = block});
      Means::Mean& mean = means.list[found->second];
      mean.places.push_back(place);
      mean.measured += read[k];
      mean.time += time[k];
    }
  }
  for (Means::Mean& mean : means.list) {
    const auto count = static_cast<double>(mean.places.size());
    mean.measured /= count;
    mean.time /= count;
  }
  return means;
}

Separable::Separable(const Subject& subject, const Record& record,
                     const std::shared_ptr<const void>& prepared, const Means& means,
                     const std::vector<std::string>& names, double prior_weight)
    : parameters_(find_parameters(subject, names)),
      means_(means),
      predictor_(subject.predictor(record, names, prepared)),
      all_(subject.measured().size() * record.rows()) {
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    (parameters_[k].proportional ? straight_ : bending_).push_back(k);
  for (std::size_t j = 0; j <= straight_.size(); ++j) {
    std::vector<std::size_t>& list = bent_by_.emplace_back();
    for (const std::size_t k : bending_)
      if (predictor_->bends(k, j < straight_.size() ? straight_[j] : Predictor::none))
        list.push_back(k);
  }
  for (std::size_t k = 0; k < parameters_.size() && prior_weight > 0.0; ++k)
    if (const record::Prior& prior = parameters_[k].prior; prior.is_known())
      priors_.push_back({static_cast<Eigen::Index>(k), std::sqrt(prior_weight) / prior.std});
  const Eigen::Index rows = means.size() + std::ssize(priors_);
  measured_.resize(rows);
  weight_ = Eigen::VectorXd::Ones(rows);
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    measured_[i] = means.list[static_cast<std::size_t>(i)].measured;
    weight_[i] = means.list[static_cast<std::size_t>(i)].weight;
  }
  for (std::size_t p = 0; p < priors_.size(); ++p)
    measured_[means.size() + static_cast<Eigen::Index>(p)] =
        priors_[p].per_unit *
        parameters_[static_cast<std::size_t>(priors_[p].parameter)].prior.value;
}

void Separable::read_priors(const Eigen::VectorXd& values, Eigen::VectorXd& readings) const {
  for (std::size_t p = 0; p < priors_.size(); ++p)
    readings[means_.size() + static_cast<Eigen::Index>(p)] =
        priors_[p].per_unit * values[priors_[p].parameter];
}

SeparableFit Separable::without_priors(SeparableFit fit) const {
  fit.residual.conservativeResize(means_.size());
  return fit;
}

Eigen::VectorXd Separable::readings(const Eigen::VectorXd& values) const {
  predictor_->readings({values.data(), static_cast<std::size_t>(values.size())}, all_);
  Eigen::VectorXd result(measured_.size());
  read_priors(values, result);
  for (Eigen::Index i = 0; i < means_.size(); ++i) {
    const std::vector<Eigen::Index>& places = means_.list[static_cast<std::size_t>(i)].places;
    double sum = 0.0;
    for (const Eigen::Index place : places) sum += all_[static_cast<std::size_t>(place)];
    result[i] = sum / static_cast<double>(places.size());
  }
  return result;
}

const Separable::Basis& Separable::basis(Eigen::VectorXd values, int left_out) const {
  Basis& kept = kept_;
  const Eigen::VectorXd before = std::exchange(kept.values, {});
  const auto count = static_cast<Eigen::Index>(straight_.size());
  std::vector<bool> is_new(straight_.size() + 1, before.size() == 0);
  for (std::size_t j = 0; j < is_new.size(); ++j)
    for (const std::size_t k : bent_by_[j]) {
      const auto place = static_cast<Eigen::Index>(k);
      if (!is_new[j]) is_new[j] = before[place] != values[place];
    }
  for (const std::size_t k : straight_) values[static_cast<Eigen::Index>(k)] = 0.0;
  if (is_new.back()) {
    kept.constant = readings(values);
    kept.columns.resize(measured_.size(), count);
    is_new.assign(is_new.size(), true);  // a column is a difference from it
  }
  read_priors(values, kept.constant);
  for (std::size_t j = 0; j < straight_.size(); ++j) {
    if (!is_new[j]) continue;
    double& value = values[static_cast<Eigen::Index>(straight_[j])];
    value = 1.0;
    kept.columns.col(static_cast<Eigen::Index>(j)) = readings(values) - kept.constant;
    value = 0.0;
  }
  if (before.size() == 0 || kept.left_out != left_out) {
    kept.left_out = left_out;
    kept.weights = weight_;
    for (Eigen::Index i = 0; left_out >= 0 && i < means_.size(); ++i)
      if (means_.list[static_cast<std::size_t>(i)].block == left_out) kept.weights[i] = 0.0;
    kept.weighted.resize(measured_.size(), count);
    kept.normal.resize(count, count);
    kept.length.resize(count);
    is_new.assign(is_new.size(), true);
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    if (!is_new[static_cast<std::size_t>(j)]) continue;
    kept.weighted.col(j) = kept.weights.cwiseProduct(kept.columns.col(j));
    const double length = kept.weighted.col(j).norm();
    kept.length[j] = length > 0.0 ? length : 1.0;
    kept.weighted.col(j) /= kept.length[j];
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    if (!is_new[static_cast<std::size_t>(j)]) continue;
    kept.normal.col(j) = kept.weighted.transpose() * kept.weighted.col(j);
    kept.normal.row(j) = kept.normal.col(j).transpose();
  }
  kept.values = std::move(values);
  return kept;
}

double Separable::to_scale(std::size_t k, double value) const {
  const Parameter& p = parameters_[k];
  if (is_logarithmic(p)) return std::log(value);
  return std::isfinite(p.upper - p.lower) ? (value - p.lower) / (p.upper - p.lower) : value;
}

double Separable::from_scale(std::size_t k, double at) const {
  const Parameter& p = parameters_[k];
  const double value = is_logarithmic(p)                  ? std::exp(at)
                       : std::isfinite(p.upper - p.lower) ? p.lower + at * (p.upper - p.lower)
                                                          : at;
  return std::clamp(value, p.lower, p.upper);
}

SeparableFit Separable::at(const Eigen::VectorXd& values, int left_out, double ridge) const {
  return without_priors(with_priors(values, left_out, ridge));
}

SeparableFit Separable::with_priors(const Eigen::VectorXd& values, int left_out,
                                    double ridge) const {
  const Basis& of = basis(values, left_out);
  SeparableFit fit{.values = values, .at_bound = std::vector<bool>(parameters_.size(), false)};
  const Eigen::VectorXd& w = of.weights;
  const Eigen::VectorXd rest = measured_ - of.constant;
  Eigen::VectorXd amounts = Eigen::VectorXd::Zero(of.columns.cols());
  if (of.columns.cols() > 0 && of.normal.allFinite() && rest.allFinite()) {
    const Eigen::VectorXd b = w.cwiseProduct(rest);
    if (ridge >= 1e-9) {
      Eigen::MatrixXd normal = of.normal;
      normal.diagonal().array() += ridge;
      amounts = algebra::solve_symmetric(normal, of.weighted.transpose() * b);
    } else {
      amounts = algebra::least_squares(of.weighted, b);
    }
    amounts = amounts.cwiseQuotient(of.length);
  }
  for (std::size_t j = 0; j < straight_.size(); ++j)
    fit.values[static_cast<Eigen::Index>(straight_[j])] = amounts[static_cast<Eigen::Index>(j)];
  fit.residual = rest - of.columns * amounts;
  fit.misfit = w.cwiseProduct(fit.residual).squaredNorm();
  for (const std::size_t k : bending_) {
    const Parameter& p = parameters_[k];
    const double v = values[static_cast<Eigen::Index>(k)];
    constexpr double near = 1e-4;
    const double at = to_scale(k, v);
    fit.at_bound[k] = (std::isfinite(p.lower) && at <= to_scale(k, p.lower) + near) ||
                      (std::isfinite(p.upper) && at >= to_scale(k, p.upper) - near);
  }
  return fit;
}

SeparableFit Separable::from(const Eigen::VectorXd& start, int left_out,
                             const std::vector<bool>& held, double ridge) const {
  std::vector<std::size_t> moving;
  for (const std::size_t k : bending_)
    if (held.empty() || !held[k]) moving.push_back(k);
  Eigen::VectorXd values = start;
  for (const std::size_t k : bending_) {
    double& v = values[static_cast<Eigen::Index>(k)];
    v = std::clamp(v, parameters_[k].lower, parameters_[k].upper);
  }
  SeparableFit best = with_priors(values, left_out, ridge);
  if (!std::isfinite(best.misfit)) return without_priors(std::move(best));
  Eigen::VectorXd w = weight_;
  if (left_out >= 0)
    for (Eigen::Index i = 0; i < means_.size(); ++i)
      if (means_.list[static_cast<std::size_t>(i)].block == left_out) w[i] = 0.0;
  const auto n = static_cast<Eigen::Index>(moving.size());
  double damping = 1e-3;
  best.converged = moving.empty();
  for (int step = 0; step < most_tries && !best.converged; ++step) {
    best.iterations = step + 1;
    Eigen::MatrixXd slope(measured_.size(), n);
    Eigen::VectorXd lower(n), upper(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t k = moving[static_cast<std::size_t>(j)];
      const auto place = static_cast<Eigen::Index>(k);
      const double here = to_scale(k, best.values[place]);
      lower[j] = to_scale(k, parameters_[k].lower) - here;
      upper[j] = to_scale(k, parameters_[k].upper) - here;
      const double h = upper[j] > small_step ? small_step : -small_step;
      Eigen::VectorXd moved = best.values;
      moved[place] = from_scale(k, here + h);
      slope.col(j) =
          w.cwiseProduct(with_priors(moved, left_out, ridge).residual - best.residual) / -h;
    }
    const LeastSquares problem(slope, w.cwiseProduct(best.residual));
    bool better = false;
    double fall = 0.0;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
      std::vector<int> side(static_cast<std::size_t>(n), 0);
      problem.solve(lower, upper, damping, d, side);
      Eigen::VectorXd moved = best.values;
      for (Eigen::Index j = 0; j < n; ++j) {
        const std::size_t k = moving[static_cast<std::size_t>(j)];
        const auto place = static_cast<Eigen::Index>(k);
        // No further than a time constant can be believed to lie.
        const double by = std::clamp(d[j], -1.5, 1.5);
        moved[place] = from_scale(k, to_scale(k, best.values[place]) + by);
      }
      SeparableFit next = with_priors(moved, left_out, ridge);
      if (std::isfinite(next.misfit) && next.misfit < best.misfit) {
        fall = best.misfit - next.misfit;
        next.iterations = best.iterations;
        best = std::move(next);
        damping = std::max(1e-9, 0.2 * damping);
        better = true;
      } else {
        damping *= 6.0;
      }
    }
    if (!better || fall <= settled_misfit * best.misfit) best.converged = true;
  }
  return without_priors(std::move(best));
}

std::vector<double> Separable::falls(Eigen::VectorXd values, std::size_t size, std::size_t place,
                                     const std::vector<double>& tried) const {
  const Basis& of = basis(values, -1);
  std::vector<Eigen::Index> others;
  for (std::size_t j = 0; j < straight_.size(); ++j)
    if (straight_[j] != size) others.push_back(static_cast<Eigen::Index>(j));
  Eigen::MatrixXd a = weight_.asDiagonal() * of.columns(Eigen::all, others);
  Eigen::VectorXd r = weight_.cwiseProduct(measured_ - of.constant);
  std::vector<double> list(tried.size(), 0.0);
  if (!a.allFinite() || !r.allFinite()) return list;
  const Eigen::MatrixXd q = algebra::PivotedQr(a).column_space();
  r -= q * (q.transpose() * r);
  for (const std::size_t k : straight_) values[static_cast<Eigen::Index>(k)] = 0.0;
  values[static_cast<Eigen::Index>(size)] = 1.0;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    values[static_cast<Eigen::Index>(place)] = tried[i];
    const Eigen::VectorXd column = weight_.cwiseProduct(readings(values) - of.constant);
    const double length = column.squaredNorm();
    const double apart = length - (q.transpose() * column).squaredNorm();
    constexpr double alike = 1e-9;
    if (apart > alike * length) list[i] = std::pow(column.dot(r), 2) / apart;
  }
  return list;
}

Eigen::MatrixXd Separable::jacobian(const Eigen::VectorXd& values) const {
  Eigen::MatrixXd result(means_.size(), values.size());
  const Basis& of = basis(values, -1);
  for (std::size_t j = 0; j < straight_.size(); ++j)
    result.col(static_cast<Eigen::Index>(straight_[j])) =
        of.columns.col(static_cast<Eigen::Index>(j)).head(means_.size());
  const Eigen::VectorXd here = readings(values);
  for (const std::size_t k : bending_) {
    const auto place = static_cast<Eigen::Index>(k);
    const double at = to_scale(k, values[place]);
    Eigen::VectorXd moved = values;
    moved[place] = from_scale(k, at + small_step);
    if (moved[place] == values[place]) moved[place] = from_scale(k, at - small_step);
    const double by = moved[place] - values[place];
    result.col(place) = by == 0.0
                            ? Eigen::VectorXd(Eigen::VectorXd::Zero(means_.size()))
                            : Eigen::VectorXd((readings(moved) - here).head(means_.size()) / by);
  }
  return result;
}

}  // namespace raceway::fit
