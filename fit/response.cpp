#include "fit/response.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <stdexcept>
#include <utility>

#include "fit/free_parameters.h"
#include "fit/shaft_response.h"

namespace raceway::fit {

namespace {

constexpr double affine_tolerance = 1e-9;  // of the largest reading
constexpr double difference_step = 1e-4;   // of the scale of a parameter
constexpr double same_optimum = 1e-6;      // of the misfit
constexpr double bound_tolerance = 1e-7;   // of the scale of a parameter
constexpr double least_fall = 1e-10;       // of the misfit: a step that promises less is not taken
constexpr double least_reading = 1e-10;    // of the readings: less is rounding
constexpr double first_damping = 1e-4;     // of the square of a column
constexpr double most_damping = 1e12;
constexpr double kept_promise = 1e-3;  // share of the promised fall that accepts a step
constexpr double no_influence = 1e-9;  // of a parameter against another
constexpr int most_iterations = 100;

/// A point within the bounds, `amount` scales away from the start in a direction of its own for
/// each parameter.
Eigen::VectorXd away(const std::vector<FitParameter>& parameters, double amount) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const FitParameter& p = parameters[k];
    const double step = amount * (1.0 + 0.3 * static_cast<double>(k)) * p.scale;
    double value = p.start + step <= p.upper ? p.start + step : p.start - step;
    x[static_cast<Eigen::Index>(k)] = std::clamp(value, p.lower, p.upper);
  }
  return x;
}

/// The problem min |r - A d|², reduced to as many rows as it has columns.
class LeastSquares {
 public:
  LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r) {
    const Eigen::Index count = a.cols();
    Eigen::MatrixXd joined(a.rows(), count + 1);
    joined << a, r;
    const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(joined);
    const Eigen::Index rows = std::min(count, a.rows());
    a_ = joined.topLeftCorner(rows, count).triangularView<Eigen::Upper>();
    r_ = joined.col(count).head(rows);
  }

  /// |r|² less what `d` leaves of it.
  [[nodiscard]] double fall(const Eigen::VectorXd& d) const {
    const Eigen::VectorXd image = a_ * d;
    return image.dot(2.0 * r_ - image);
  }

  /// The minimum for d within [lower, upper], or of |r - A d|² + damping Σ |A_k|² d_k², by an
  /// active set; returns whether it settled. `side` says which are held at which bound.
  bool solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
             Eigen::VectorXd& d, std::vector<int>& side) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd r_;
};

bool LeastSquares::solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
                         Eigen::VectorXd& d, std::vector<int>& side) const {
  const Eigen::Index count = a_.cols();
  Eigen::MatrixXd a = a_;
  Eigen::VectorXd r = r_;
  if (damping > 0.0) {
    a.conservativeResize(a_.rows() + count, Eigen::NoChange);
    a.bottomRows(count) = Eigen::MatrixXd((std::sqrt(damping) * a_.colwise().norm()).asDiagonal());
    r.conservativeResize(r_.size() + count);
    r.tail(count).setZero();
  }
  side.assign(static_cast<std::size_t>(count), 0);
  d = Eigen::VectorXd::Zero(count);
  const Eigen::MatrixXd gram = a.transpose() * a;
  const Eigen::VectorXd right = a.transpose() * r;
  for (int round = 0; round < 50; ++round) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index k = 0; k < count; ++k) {
      const int s = side[static_cast<std::size_t>(k)];
      if (s == 0)
        free.push_back(k);
      else
        d[k] = s < 0 ? lower[k] : upper[k];
    }
    if (!free.empty()) {
      Eigen::MatrixXd columns(a.rows(), static_cast<Eigen::Index>(free.size()));
      Eigen::VectorXd rest = r;
      for (Eigen::Index k = 0; k < count; ++k)
        if (side[static_cast<std::size_t>(k)] != 0) rest -= a.col(k) * d[k];
      for (std::size_t j = 0; j < free.size(); ++j)
        columns.col(static_cast<Eigen::Index>(j)) = a.col(free[j]);
      const Eigen::VectorXd solution = columns.colPivHouseholderQr().solve(rest);
      if (!solution.allFinite()) return false;
      for (std::size_t j = 0; j < free.size(); ++j)
        d[free[j]] = solution[static_cast<Eigen::Index>(j)];
    }
    // The worst violation first: beyond a bound, then a held one that wants back inside.
    Eigen::Index worst = -1;
    double most = 0.0;
    int worst_side = 0;
    for (const Eigen::Index k : free) {
      const double below = lower[k] - d[k], above = d[k] - upper[k];
      if (std::max(below, above) > most) {
        most = std::max(below, above);
        worst = k;
        worst_side = below > above ? -1 : 1;
      }
    }
    if (worst >= 0) {
      side[static_cast<std::size_t>(worst)] = worst_side;
      continue;
    }
    const Eigen::VectorXd downhill = right - gram * d;
    for (Eigen::Index k = 0; k < count; ++k) {
      const int s = side[static_cast<std::size_t>(k)];
      const double inward = s < 0 ? downhill[k] : s > 0 ? -downhill[k] : 0.0;
      if (inward > most + 1e-9 * std::sqrt(gram(k, k)) * r.norm()) {
        most = inward;
        worst = k;
      }
    }
    if (worst < 0) return true;
    side[static_cast<std::size_t>(worst)] = 0;
  }
  return false;
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
                                    const std::vector<FitParameter>& parameters) {
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
/// that comes to the misfit of `known` ends there: it has no more to tell than that.
std::optional<Minimum> minimum_from(const Response& response, const Whitening& whitening,
                                    const Eigen::VectorXd& measured, const Eigen::VectorXd& start,
                                    double known) {
  const Eigen::VectorXd scale = scales(response);
  const Eigen::Index count = scale.size();
  Eigen::VectorXd lower(count), upper(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const FitParameter& p = response.parameters[static_cast<std::size_t>(k)];
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
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    if (same_misfit(at.misfit, known)) return at;
    at.slope = response.jacobian(at.values);
    at.jacobian = whitening(Eigen::MatrixXd(at.slope * scale.asDiagonal()));
    if (!at.jacobian.allFinite()) return std::nullopt;
    const LeastSquares linearised(at.jacobian, residual);
    const double least = std::max(least_fall * at.misfit, rounding);
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
    const FitParameter& p = response.parameters[static_cast<std::size_t>(k)];
    const bool bound = fit.values[k] - p.lower <= bound_tolerance * p.scale ||
                       p.upper - fit.values[k] <= bound_tolerance * p.scale;
    fit.at_bound[static_cast<std::size_t>(k)] = bound;
    if (!bound) free.push_back(k);
  }
  fit.tangent = jacobian(Eigen::all, free);
  fit.standard_errors = Eigen::VectorXd::Constant(count, unset);
  if (!free.empty() && fit.tangent.allFinite()) {
    const Eigen::MatrixXd covariance =
        (fit.tangent.transpose() * fit.tangent).completeOrthogonalDecomposition().pseudoInverse();
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
    const FitParameter& p = parameters[static_cast<std::size_t>(k)];
    const double step = difference_step * p.scale;
    Eigen::VectorXd high = x, low = x;
    high[k] = std::min(x[k] + step, p.upper);
    low[k] = std::max(x[k] - step, p.lower);
    Eigen::VectorXd above = readings(high), below = readings(low);
    // Next to a point without balance, the side that has one.
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
  for (const double amount : {0.5, 1.3, 3.1}) {
    const Eigen::VectorXd x = away(parameters, amount);
    const Eigen::VectorXd true_readings = readings(x);
    const double error = (form.constant + form.slope * x - true_readings).cwiseAbs().maxCoeff();
    if (!(error <= affine_tolerance * true_readings.cwiseAbs().maxCoeff())) return;
  }
  affine = std::move(form);
}

Response model_response(const Model& model, const DataSet& data,
                        const std::vector<std::string>& names, std::span<const Balance> entered) {
  Response response;
  Model wanted = model;
  wanted.free = names;
  const std::vector<ModelParameter> chosen =
      names.empty() ? std::vector<ModelParameter>() : free_parameters(wanted);
  for (const ModelParameter& p : chosen) {
    FitParameter parameter{
        .name = p.name, .unit = p.unit, .start = p.get(model), .lower = p.lower, .upper = p.upper};
    const double size = std::max(std::abs(parameter.start), std::abs(p.initial));
    const double range = p.upper - p.lower;
    parameter.scale = size > 0.0 ? size : std::isfinite(range) && range > 0.0 ? 0.01 * range : 1.0;
    response.parameters.push_back(parameter);
  }
  if (model.shaft) {
    response.readings = displacement_readings(model, data.rows, chosen);
    return response;
  }
  // Rows remember what a parameter leaves alone: all before the stage at which it acts first.
  struct Rows {
    Model model;
    Steps steps;
    std::vector<RowPredictor> predictors{};
    std::vector<Stage> stage{};  // of each parameter
    Eigen::VectorXd last{};
  };
  const auto rows = std::make_shared<Rows>(Rows{model, Steps(model)});
  rows->predictors.reserve(data.rows.size());
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    rows->predictors.emplace_back(rows->model, rows->steps, data.rows[i].point,
                                  record_of(data.rows[i]), entered.empty() ? nullptr : entered[i]);
  for (const ModelParameter& p : chosen)
    rows->stage.push_back(first_stage(rows->model, rows->steps, p.effect));
  response.readings = [rows, chosen](const Eigen::VectorXd& x) {
    Stage from = rows->last.size() == x.size() ? Stage::reading : Stage::condition;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      if (from != Stage::condition && x[at] == rows->last[at]) continue;
      chosen[k].set(rows->model, x[at]);
      from = std::min(from, rows->stage[k]);
    }
    rows->last.resize(0);  // until all rows have it
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows->predictors.size()));
    predict_all(rows->model, rows->steps, rows->predictors,
                std::span(readings.data(), rows->predictors.size()), from);
    rows->last = x;
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
      const FitParameter& p = response.parameters[static_cast<std::size_t>(k)];
      lower[k] = p.lower / p.scale;
      upper[k] = p.upper / p.scale;
    }
    std::vector<int> side;
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
    std::optional<Minimum> found = minimum_from(response, whitening, measured, next.front(),
                                                looked_around ? unset : best.misfit);
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

}  // namespace raceway::fit
