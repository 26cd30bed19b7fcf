#include "fit/response.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "fit/free_parameters.h"
#include "fit/prediction.h"
#include "fit/shaft_response.h"

namespace raceway::fit {

namespace {

constexpr double affine_tolerance = 1e-9;  // of the largest reading
constexpr double difference_step = 1e-4;   // of the scale of a parameter
constexpr double same_optimum = 1e-6;      // of the misfit
constexpr double bound_tolerance = 1e-7;   // of the scale of a parameter

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

/// Minimises |r - A d|² for d within [lower, upper] by an active set; returns whether it settled.
bool bounded_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r,
                           const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                           Eigen::VectorXd& d, std::vector<int>& side) {
  const Eigen::Index count = a.cols();
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

/// The response as Ceres sees it: whitened, parameters in units of their scale.
class WhitenedResiduals : public ceres::CostFunction {
 public:
  WhitenedResiduals(const Response& response, const Whitening& whitening,
                    const Eigen::VectorXd& measured, const Eigen::VectorXd& scale)
      : response_(response), whitening_(whitening), measured_(measured), scale_(scale) {
    set_num_residuals(static_cast<int>(measured.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(scale.size()));
  }

  bool Evaluate(double const* const* x, double* residual, double** jacobians) const override {
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(x[0], scale_.size()).cwiseProduct(scale_);
    const Eigen::VectorXd prediction = response_.at(values);
    if (!prediction.allFinite()) return false;
    Eigen::Map<Eigen::VectorXd>(residual, measured_.size()) =
        whitening_(Eigen::VectorXd(measured_ - prediction));
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    const Eigen::MatrixXd derivatives =
        whitening_(Eigen::MatrixXd(-response_.jacobian(values) * scale_.asDiagonal()));
    if (!derivatives.allFinite()) return false;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        jacobians[0], measured_.size(), scale_.size()) = derivatives;
    return true;
  }

 private:
  const Response& response_;
  const Whitening& whitening_;
  const Eigen::VectorXd& measured_;
  const Eigen::VectorXd& scale_;
};

Eigen::VectorXd scales(const Response& response) {
  Eigen::VectorXd scale(static_cast<Eigen::Index>(response.parameters.size()));
  for (Eigen::Index k = 0; k < scale.size(); ++k)
    scale[k] = response.parameters[static_cast<std::size_t>(k)].scale;
  return scale;
}

/// One minimum from one start; nothing where the optimiser gave up.
std::optional<Eigen::VectorXd> minimum_from(const Response& response, const Whitening& whitening,
                                            const Eigen::VectorXd& measured,
                                            const Eigen::VectorXd& start, double& misfit) {
  const Eigen::VectorXd scale = scales(response);
  Eigen::VectorXd x = start.cwiseQuotient(scale);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const FitParameter& p = response.parameters[static_cast<std::size_t>(k)];
    x[k] = std::clamp(x[k], p.lower / p.scale, p.upper / p.scale);
  }
  if (!response.at(x.cwiseProduct(scale)).allFinite()) return std::nullopt;
  ceres::Problem problem;
  problem.AddResidualBlock(new WhitenedResiduals(response, whitening, measured, scale), nullptr,
                           x.data());
  for (int k = 0; k < x.size(); ++k) {
    const FitParameter& p = response.parameters[static_cast<std::size_t>(k)];
    if (std::isfinite(p.lower)) problem.SetParameterLowerBound(x.data(), k, p.lower / p.scale);
    if (std::isfinite(p.upper)) problem.SetParameterUpperBound(x.data(), k, p.upper / p.scale);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-9;
  options.gradient_tolerance = 1e-10;
  options.parameter_tolerance = 1e-9;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (summary.termination_type != ceres::CONVERGENCE) return std::nullopt;
  misfit = 2.0 * summary.final_cost;
  return Eigen::VectorXd(x.cwiseProduct(scale));
}

/// What follows from the values: prediction, residual, tangent, standard errors.
void complete(const Response& response, const Whitening& whitening, const Eigen::VectorXd& measured,
              ResponseFit& fit) {
  fit.prediction = response.at(fit.values);
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
  const Eigen::MatrixXd full = whitening(response.jacobian(fit.values));
  fit.tangent.resize(full.rows(), static_cast<Eigen::Index>(free.size()));
  for (std::size_t j = 0; j < free.size(); ++j)
    fit.tangent.col(static_cast<Eigen::Index>(j)) =
        full.col(free[j]) * response.parameters[static_cast<std::size_t>(free[j])].scale;
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
                        const std::vector<std::string>& names) {
  Response response;
  Model wanted = model;
  wanted.free = names;
  const std::vector<ModelParameter> chosen = free_parameters(wanted);
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
  // Rows remember their balance, which most parameters leave alone.
  struct Rows {
    Model model;
    Steps steps;
    std::vector<RowPredictor> predictors;
  };
  const auto rows = std::make_shared<Rows>(Rows{model, Steps(model), {}});
  rows->predictors.reserve(data.rows.size());
  for (const Row& row : data.rows)
    rows->predictors.emplace_back(rows->model, rows->steps, row.point, record_of(row));
  response.readings = [rows, chosen](const Eigen::VectorXd& x) {
    for (std::size_t k = 0; k < chosen.size(); ++k)
      chosen[k].set(rows->model, x[static_cast<Eigen::Index>(k)]);
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows->predictors.size()));
    const bearing::BearingEquilibrium* neighbour = nullptr;
    for (std::size_t i = 0; i < rows->predictors.size(); ++i) {
      RowPredictor& row = rows->predictors[i];
      readings[static_cast<Eigen::Index>(i)] =
          row.predict(rows->model, rows->steps, row.equilibrium() ? nullptr : neighbour);
      if (row.equilibrium()) neighbour = row.equilibrium();
    }
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
    fit.converged = bounded_least_squares(a, r, lower, upper, x, side);
    fit.values = x.cwiseProduct(scale);
    if (fit.converged) complete(response, whitening, measured, fit);
    return fit;
  }
  double best = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& start : starts) {
    double misfit = unset;
    const auto found = minimum_from(response, whitening, measured, start, misfit);
    if (!found) continue;
    const bool again = std::abs(misfit - best) <= same_optimum * std::max(1.0, best);
    if (misfit < best) {
      best = misfit;
      fit.values = *found;
    }
    if (again) {
      fit.converged = true;
      break;
    }
    fit.converged = false;
  }
  if (fit.converged) complete(response, whitening, measured, fit);
  return fit;
}

}  // namespace raceway::fit
