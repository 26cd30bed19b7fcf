#include "fit/response.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <stdexcept>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "fit/least_squares.h"

namespace raceway::fit {

namespace {

constexpr double affine_tolerance = 1e-9;  // of the largest reading
constexpr double difference_step = 1e-4;   // of the scale of a parameter
constexpr double same_optimum = 1e-6;      // of the misfit
constexpr double bound_tolerance = 1e-7;   // of the scale of a parameter
constexpr double least_fall = 1e-10;       // of the misfit: a step that promises less is not taken
constexpr double least_reading = 1e-10;    // of the readings: less is rounding
constexpr double coarse_fall = 0.05;    // in -2 ln L: a step that promises less ends a coarse fit
constexpr double coarse_share = 1e-4;   // of the misfit: likewise
constexpr double first_damping = 1e-4;  // of the square of a column
constexpr double most_damping = 1e12;
constexpr double kept_promise = 1e-3;  // share of the promised fall that accepts a step
constexpr double no_influence = 1e-9;  // of a parameter against another
constexpr int most_iterations = 100;

/// A point within the bounds, `amount` scales away from the start in a direction of its own for
/// each parameter.
Eigen::VectorXd away(const std::vector<Parameter>& parameters, double amount) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter& p = parameters[k];
    const double step = amount * (1.0 + 0.3 * static_cast<double>(k)) * p.scale;
    const double above = p.upper - p.start, below = p.start - p.lower;
    // Where there is no room for it on either side, a share of the larger room: points of different
    // amounts stay apart.
    const double part = amount / (1.0 + amount);
    x[static_cast<Eigen::Index>(k)] = step <= above    ? p.start + step
                                      : step <= below  ? p.start - step
                                      : above >= below ? p.start + part * above
                                                       : p.start - part * below;
  }
  return x;
}

Eigen::VectorXd scales(const Response& response) {
  Eigen::VectorXd scale(static_cast<Eigen::Index>(response.parameters.size()));
  for (Eigen::Index k = 0; k < scale.size(); ++k)
    scale[k] = response.parameters[static_cast<std::size_t>(k)].scale;
  return scale;
}

/// A minimum of the misfit, and what is known there.
struct Minimum {
  Eigen::VectorXd values{}, prediction{};
  Eigen::MatrixXd slope{};     ///< of the readings
  Eigen::MatrixXd jacobian{};  ///< the same whitened, in units of the scales
  double misfit = unset;

  /// Parameters that change nothing here, as the shape of an effect of size zero: with another
  /// value of theirs the minimum may be elsewhere.
  [[nodiscard]] std::vector<Eigen::Index> without_influence() const {
    const Eigen::VectorXd norm = jacobian.colwise().norm();
    std::vector<Eigen::Index> found;
    for (Eigen::Index k = 0; k < norm.size(); ++k)
      if (norm[k] <= no_influence * norm.maxCoeff()) found.push_back(k);
    return found;
  }
};

/// A minimum with other values of the parameters that have no influence there: both ends of their
/// range and its middle, in ratio where the range is wide.
std::vector<Eigen::VectorXd> around(const Minimum& minimum,
                                    const std::vector<Parameter>& parameters) {
  std::vector<Eigen::VectorXd> points;
  for (const Eigen::Index k : minimum.without_influence()) {
    const auto& [low, high] = std::pair(parameters[static_cast<std::size_t>(k)].lower,
                                        parameters[static_cast<std::size_t>(k)].upper);
    if (!std::isfinite(high - low)) continue;
    const double middle =
        low > 0.0 && high > 10.0 * low ? std::sqrt(low * high) : 0.5 * (low + high);
    for (const double value : {low, middle, high}) {
      points.push_back(minimum.values);
      points.back()[k] = value;
    }
  }
  return points;
}

bool same_misfit(double found, double known) {
  return std::isfinite(known) && std::abs(found - known) <= same_optimum * std::max(1.0, known);
}

/// One minimum from one start by the method of Levenberg and Marquardt, the bounds kept inside each
/// step: the linearised problem is solved under them, so that a parameter at a bound slows nothing
/// down. Nothing where no step goes down although the linearised problem promises one. A search
/// that comes to the misfit of `known` ends there: it has no more to tell than that. With `coarse`
/// it ends where a step promises little, and takes one-sided derivatives.
std::optional<Minimum> minimum_from(const Response& response, const Whitening& whitening,
                                    const Eigen::VectorXd& measured, const Eigen::VectorXd& start,
                                    double known, int& iterations, bool coarse = false) {
  const Eigen::VectorXd scale = scales(response);
  const Eigen::Index count = scale.size();
  Eigen::VectorXd lower(count), upper(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Parameter& p = response.parameters[static_cast<std::size_t>(k)];
    lower[k] = p.lower / p.scale;
    upper[k] = p.upper / p.scale;
  }
  Eigen::VectorXd x = start.cwiseQuotient(scale).cwiseMax(lower).cwiseMin(upper);
  Minimum at{.values = x.cwiseProduct(scale)};
  at.prediction = response.at(at.values);
  if (!at.prediction.allFinite()) return std::nullopt;
  Eigen::VectorXd residual = whitening(Eigen::VectorXd(measured - at.prediction));
  at.misfit = residual.squaredNorm();
  const double rounding = std::pow(least_reading, 2) * whitening(measured).squaredNorm();
  double damping = first_damping, harder = 4.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration, ++iterations) {
    if (same_misfit(at.misfit, known)) return at;
    at.slope =
        coarse ? response.slope_beside(at.values, at.prediction) : response.jacobian(at.values);
    at.jacobian = whitening(Eigen::MatrixXd(at.slope * scale.asDiagonal()));
    if (!at.jacobian.allFinite()) return std::nullopt;
    const LeastSquares linearised(at.jacobian, residual);
    const double least = coarse ? std::max(coarse_fall, coarse_share * at.misfit)
                                : std::max(least_fall * at.misfit, rounding);
    Eigen::VectorXd step;
    std::vector<int> side;
    if (!linearised.solve(lower - x, upper - x, 0.0, step, side)) return std::nullopt;
    const double undamped = linearised.fall(step);
    if (undamped <= least) return at;
    for (;; damping *= harder, harder *= 2.0) {
      if (damping > most_damping || !linearised.solve(lower - x, upper - x, damping, step, side))
        return std::nullopt;
      const double promised = linearised.fall(step);
      if (promised <= least) {
        // Stuck: at a minimum but for the rounding of the readings, or in front of a wall.
        if (undamped > same_optimum * std::max(1.0, at.misfit)) return std::nullopt;
        return at;
      }
      const Eigen::VectorXd moved = (x + step).cwiseMax(lower).cwiseMin(upper);
      const Eigen::VectorXd values = moved.cwiseProduct(scale);
      Eigen::VectorXd prediction = response.at(values);
      if (!prediction.allFinite()) continue;
      Eigen::VectorXd left = whitening(Eigen::VectorXd(measured - prediction));
      const double misfit = left.squaredNorm();
      const double kept = (at.misfit - misfit) / promised;
      if (!(kept > kept_promise)) continue;
      x = moved;
      at.values = values;
      at.prediction = std::move(prediction);
      residual = std::move(left);
      at.misfit = misfit;
      damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * kept - 1.0, 3));
      harder = 4.0;
      break;
    }
  }
  return std::nullopt;
}

/// What follows from the values and what is known there; `jacobian` as in Minimum.
void complete(const Response& response, const Whitening& whitening, const Eigen::VectorXd& measured,
              const Eigen::VectorXd& prediction, const Eigen::MatrixXd& jacobian,
              ResponseFit& fit) {
  fit.prediction = prediction;
  fit.residual = whitening(Eigen::VectorXd(measured - fit.prediction));
  fit.misfit = fit.residual.squaredNorm();
  const Eigen::Index count = fit.values.size();
  fit.at_bound.assign(static_cast<std::size_t>(count), false);
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Parameter& p = response.parameters[static_cast<std::size_t>(k)];
    const bool bound = fit.values[k] - p.lower <= bound_tolerance * p.scale ||
                       p.upper - fit.values[k] <= bound_tolerance * p.scale;
    fit.at_bound[static_cast<std::size_t>(k)] = bound;
    if (!bound) free.push_back(k);
  }
  fit.tangent = jacobian(Eigen::all, free);
  fit.standard_errors = Eigen::VectorXd::Constant(count, unset);
  if (!free.empty() && fit.tangent.allFinite()) {
    const Eigen::MatrixXd covariance =
        algebra::pseudo_inverse(fit.tangent.transpose() * fit.tangent);
    for (std::size_t j = 0; j < free.size(); ++j) {
      const auto c = static_cast<Eigen::Index>(j);
      fit.standard_errors[free[j]] = std::sqrt(std::max(0.0, covariance(c, c))) *
                                     response.parameters[static_cast<std::size_t>(free[j])].scale;
    }
  }
  if (!fit.residual.allFinite() || !fit.tangent.allFinite()) fit.converged = false;
}

}  // namespace

Eigen::VectorXd Response::start() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k)
    x[static_cast<Eigen::Index>(k)] = parameters[k].start;
  return x;
}

Eigen::VectorXd Response::at(const Eigen::VectorXd& x) const {
  if (affine) return affine->constant + affine->slope * x;
  return readings(x);
}

Eigen::MatrixXd Response::jacobian(const Eigen::VectorXd& x) const {
  if (affine) return affine->slope;
  Eigen::MatrixXd result;
  if (x.size() == 0) result.resize(readings(x).size(), 0);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const Parameter& p = parameters[static_cast<std::size_t>(k)];
    const double step = difference_step * p.scale;
    Eigen::VectorXd high = x, low = x;
    high[k] = std::min(x[k] + step, p.upper);
    low[k] = std::max(x[k] - step, p.lower);
    Eigen::VectorXd above = readings(high), below = readings(low);
    // Next to a point that cannot be predicted, the side that has one.
    if (!above.allFinite()) {
      high[k] = x[k];
      above = readings(high);
    } else if (!below.allFinite()) {
      low[k] = x[k];
      below = readings(low);
    }
    const Eigen::VectorXd slope = (above - below) / (high[k] - low[k]);
    if (result.size() == 0) result.resize(slope.size(), x.size());
    result.col(k) = slope;
  }
  return result;
}

Eigen::MatrixXd Response::slope_beside(const Eigen::VectorXd& x,
                                       const Eigen::VectorXd& at_x) const {
  Eigen::MatrixXd result(at_x.size(), x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const Parameter& p = parameters[static_cast<std::size_t>(k)];
    const double step = difference_step * p.scale;
    Eigen::VectorXd beside = x;
    beside[k] = x[k] + step <= p.upper ? x[k] + step : x[k] - step;
    result.col(k) = (readings(beside) - at_x) / (beside[k] - x[k]);
  }
  return result;
}

void Response::find_affine_form() {
  const Eigen::VectorXd centre = start();
  const Eigen::VectorXd at_centre = readings(centre);
  if (!at_centre.allFinite()) return;
  Affine form;
  form.slope.resize(at_centre.size(), centre.size());
  const Eigen::VectorXd moved = away(parameters, 0.5);
  for (Eigen::Index k = 0; k < centre.size(); ++k) {
    Eigen::VectorXd x = centre;
    x[k] = moved[k];
    form.slope.col(k) = (readings(x) - at_centre) / (x[k] - centre[k]);
  }
  form.constant = at_centre - form.slope * centre;
  if (!form.slope.allFinite()) return;
  std::vector<Eigen::Index> ends{at_centre.size()};
  if (!parts.empty()) ends.assign(parts.begin() + 1, parts.end());
  for (const double amount : {0.5, 1.3, 3.1}) {
    const Eigen::VectorXd x = away(parameters, amount);
    const Eigen::VectorXd true_readings = readings(x);
    const Eigen::VectorXd error = form.constant + form.slope * x - true_readings;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const Eigen::Index begin = k == 0 ? 0 : ends[k - 1], size = ends[k] - begin;
      if (size > 0 &&
          !(error.segment(begin, size).cwiseAbs().maxCoeff() <=
            affine_tolerance * true_readings.segment(begin, size).cwiseAbs().maxCoeff()))
        return;
    }
  }
  affine = std::move(form);
}

Response response_of(const Subject& subject, std::shared_ptr<const Record> record,
                     const Observations& observed, const std::vector<std::string>& names,
                     const std::shared_ptr<const void>& prepared) {
  Response response;
  if (!names.empty()) response.parameters = find_parameters(subject, names);
  struct Rows {
    std::shared_ptr<const Record> record;
    std::shared_ptr<const void> prepared;
    std::unique_ptr<Predictor> predictor;
    std::vector<double> all;  // of every channel at every row
    std::vector<std::size_t> places;
  };
  const std::size_t count = record->rows();
  const auto rows = std::make_shared<Rows>(
      Rows{record, prepared, subject.predictor(*record, names, prepared),
           std::vector<double>(subject.measured().size() * count), observed.places(count)});
  response.parts = observed.first;
  response.readings = [rows](const Eigen::VectorXd& x) {
    rows->predictor->readings({x.data(), static_cast<std::size_t>(x.size())}, rows->all);
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows->places.size()));
    for (std::size_t i = 0; i < rows->places.size(); ++i)
      readings[static_cast<Eigen::Index>(i)] = rows->all[rows->places[i]];
    return readings;
  };
  return response;
}

ResponseFit fit_response(const Response& response, const Whitening& whitening,
                         const Eigen::VectorXd& measured,
                         const std::vector<Eigen::VectorXd>& starts) {
  ResponseFit fit;
  if (response.parameters.empty()) {
    fit.values.resize(0);
    fit.converged = true;
    fit.prediction = response.at(fit.values);
    fit.residual = whitening(Eigen::VectorXd(measured - fit.prediction));
    fit.tangent.resize(measured.size(), 0);
    fit.slope = fit.tangent;
    fit.misfit = fit.residual.squaredNorm();
    return fit;
  }
  if (response.affine) {
    const Eigen::VectorXd scale = scales(response);
    const Eigen::MatrixXd a =
        whitening(Eigen::MatrixXd(response.affine->slope * scale.asDiagonal()));
    const Eigen::VectorXd r = whitening(Eigen::VectorXd(measured - response.affine->constant));
    Eigen::VectorXd lower(scale.size()), upper(scale.size()), x;
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
      const Parameter& p = response.parameters[static_cast<std::size_t>(k)];
      lower[k] = p.lower / p.scale;
      upper[k] = p.upper / p.scale;
    }
    std::vector<int> side;
    fit.iterations = 1;
    fit.converged = LeastSquares(a, r).solve(lower, upper, 0.0, x, side);
    fit.values = x.cwiseProduct(scale);
    if (fit.converged) {
      fit.slope = response.affine->slope;
      complete(response, whitening, measured, response.at(fit.values), a, fit);
    }
    return fit;
  }
  Minimum best{.misfit = std::numeric_limits<double>::infinity()};
  std::deque<Eigen::VectorXd> next(starts.begin(), starts.end());
  bool looked_around = false, once_more = false;
  while (!next.empty()) {
    // A look around starts where the misfit is that of the best.
    std::optional<Minimum> found =
        minimum_from(response, whitening, measured, next.front(),
                     looked_around ? unset : best.misfit, fit.iterations);
    next.pop_front();
    if (found) {
      const bool again = same_misfit(found->misfit, best.misfit);
      fit.converged = again || (fit.converged && found->misfit > best.misfit);
      if (!again && found->misfit < best.misfit) {
        best = *std::move(found);
        once_more = false;
      }
    }
    if (next.empty() && !fit.converged && !once_more && std::isfinite(best.misfit)) {
      once_more = true;  // the best of all starts, to be reached again
      for (const double factor : {0.8, 1.25}) next.push_back(factor * best.values);
    }
    if (!fit.converged || (looked_around && !next.empty())) continue;
    if (looked_around) break;
    looked_around = true;
    const std::vector<Eigen::VectorXd> others = around(best, response.parameters);
    if (others.empty()) break;
    next.assign(others.begin(), others.end());
  }
  fit.values = best.values;
  fit.slope = std::move(best.slope);
  if (fit.converged) complete(response, whitening, measured, best.prediction, best.jacobian, fit);
  return fit;
}

ResponseFit coarse_fit(const Response& response, const Whitening& whitening,
                       const Eigen::VectorXd& measured, const Eigen::VectorXd& start) {
  ResponseFit fit;
  std::optional<Minimum> found =
      minimum_from(response, whitening, measured, start, unset, fit.iterations, true);
  if (!found) return fit;
  fit.converged = true;
  fit.values = found->values;
  fit.slope = std::move(found->slope);
  complete(response, whitening, measured, found->prediction, found->jacobian, fit);
  return fit;
}

Parameter ResponseFit::fitted(const Response& response, std::size_t parameter) const {
  Parameter p = response.parameters[parameter];
  const auto at = static_cast<Eigen::Index>(parameter);
  p.value = values[at];
  p.std = standard_errors[at];
  if (at_bound[parameter])
    p.at_bound = p.value - p.lower <= p.upper - p.value ? Bound::lower : Bound::upper;
  return p;
}

}  // namespace raceway::fit
