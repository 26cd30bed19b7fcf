#include "fit/calibrate.h"

#include <ceres/ceres.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fit/prediction.h"
#include "fit/quantity.h"
#include "fit/shaft_prediction.h"
#include "fit/shaft_response.h"

namespace raceway::fit {

namespace {

constexpr double dependent = 1e-6;  // share of a unit column that others leave; below, it is theirs
constexpr double difference_step = 1e-5;  // of the size of a parameter
constexpr double shaft_step = 1e-4;       // the same, where balances of sets are differenced
constexpr std::size_t chunk = 64;         // rows that a thread takes
constexpr double bound_tolerance = 1e-7;  // of the scale of a parameter

/// A typical size of a parameter, so that the optimiser works with numbers of order one.
double typical_size(const ModelParameter& p, double start) {
  const double size = std::max(std::abs(start), std::abs(p.initial));
  if (size > 0.0) return size;
  const double range = p.upper - p.lower;
  return std::isfinite(range) && range > 0.0 ? 0.01 * range : 1.0;
}

/// Weighted residuals of all rows and their derivatives by the free parameters.
class Residuals {
 public:
  Residuals(const Model& model, const DataSet& data, std::vector<ModelParameter> parameters)
      : model_(model), steps_(model), parameters_(std::move(parameters)) {
    weighted_ = !data.rows.empty();
    std::vector<FrictionPrediction> predictions;
    std::vector<double> displacements;
    std::vector<Row> shaft_rows;
    if (model.shaft)
      displacements = predict_displacement(model, data.rows);
    else
      predictions = predict_rows(model, data);
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
      const Row& row = data.rows[i];
      if (!std::isfinite(model.shaft ? displacements[i] : predictions[i].reading) ||
          !std::isfinite(row.measured)) {
        lines_not_predicted_.push_back(row.line);
        continue;
      }
      if (model.shaft) {
        shaft_rows.push_back(row);
      } else {
        const bool as_entered = predictions[i].condition == effects::Condition{};
        predictors_.emplace_back(model, steps_, row.point, record_of(row),
                                 as_entered ? predictions[i].equilibrium : nullptr);
      }
      measured_.push_back(row.measured);
      stds_.push_back(row.std);
      weighted_ = weighted_ && row.std > 0.0 && std::isfinite(row.std);
    }
    if (model.shaft) shaft_.emplace(model, shaft_rows);
    if (!weighted_) {
      some_std_ = std::any_of(stds_.begin(), stds_.end(), [](double s) { return s > 0.0; });
      // Readings are scaled to order one.
      double square = 0.0;
      for (const double m : measured_) square += m * m;
      const double size = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, rows())));
      stds_.assign(rows(), size > 0.0 ? size : 1.0);
    }
    own_stds_ = stds_;
  }

  [[nodiscard]] std::size_t rows() const { return measured_.size(); }
  [[nodiscard]] bool weighted() const { return weighted_; }
  [[nodiscard]] bool some_std() const { return some_std_; }
  [[nodiscard]] const std::vector<ModelParameter>& parameters() const { return parameters_; }
  [[nodiscard]] const std::vector<int>& lines_not_predicted() const { return lines_not_predicted_; }

  /// Counts a scatter common to all rows beside their own standard deviation [N m] or [m].
  void set_excess_scatter(double excess) {
    for (std::size_t i = 0; i < rows(); ++i) stds_[i] = std::hypot(own_stds_[i], excess);
  }

  /// χ² against the rows' own standard deviations widened by a common scatter [1]; `errors` are
  /// prediction minus reading [N m] or [m].
  [[nodiscard]] double chi_square(const Eigen::VectorXd& errors, double excess) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < rows(); ++i) {
      const double t = errors[static_cast<Eigen::Index>(i)] / std::hypot(own_stds_[i], excess);
      sum += t * t;
    }
    return sum;
  }

  /// Prediction minus reading [N m] or [m].
  [[nodiscard]] Eigen::VectorXd errors(const Eigen::VectorXd& values) const {
    Eigen::VectorXd r = evaluate(values, nullptr);
    for (std::size_t i = 0; i < rows(); ++i) r[static_cast<Eigen::Index>(i)] *= stds_[i];
    return r;
  }

  /// Root mean square of prediction minus reading [N m] or [m].
  [[nodiscard]] double rmse(const Eigen::VectorXd& values) const {
    return errors(values).norm() / std::sqrt(static_cast<double>(rows()));
  }

  /// Residuals at these values of the parameters; the Jacobian (rows x parameters) where asked for.
  /// NaN where the model cannot take the values.
  [[nodiscard]] Eigen::VectorXd evaluate(const Eigen::VectorXd& values,
                                         Eigen::MatrixXd* jacobian) const {
    try {
      return residuals_at(values, jacobian);
    } catch (const std::invalid_argument&) {  // no bearing has these values together
      if (jacobian)
        *jacobian =
            Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows()), values.size(), unset);
      return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(rows()), unset);
    }
  }

 private:
  [[nodiscard]] Eigen::VectorXd residuals_at(const Eigen::VectorXd& values,
                                             Eigen::MatrixXd* jacobian) const {
    Model model = model_;
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      parameters_[k].set(model, values[static_cast<Eigen::Index>(k)]);
    const Eigen::VectorXd readings = predicted(model);
    const Eigen::Map<const Eigen::ArrayXd> measured(measured_.data(), readings.size());
    const Eigen::Map<const Eigen::ArrayXd> stds(stds_.data(), readings.size());
    if (jacobian) {
      jacobian->resize(readings.size(), values.size());
      for (std::size_t k = 0; k < parameters_.size(); ++k) {
        jacobian->col(static_cast<Eigen::Index>(k)) =
            (derivative(model, parameters_[k], readings).array() / stds).matrix();
        parameters_[k].set(model, values[static_cast<Eigen::Index>(k)]);
      }
    }
    return ((readings.array() - measured) / stds).matrix();
  }

  [[nodiscard]] Eigen::VectorXd predicted(const Model& model) const {
    if (model.shaft) return displaced(model);
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows()));
    predict_all(model, steps_, predictors_, std::span(readings.data(), rows()));
    return readings;
  }

  /// `reading` of each row, shared among threads; rows do not see each other.
  template <typename Reading>
  [[nodiscard]] Eigen::VectorXd of_rows(const Reading& reading) const {
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows()));
    tbb::parallel_for(std::size_t{0}, (rows() + chunk - 1) / chunk, [&](std::size_t c) {
      for (std::size_t i = c * chunk; i < std::min(rows(), (c + 1) * chunk); ++i)
        readings[static_cast<Eigen::Index>(i)] = reading(predictors_[i]);
    });
    return readings;
  }

  [[nodiscard]] Eigen::VectorXd displaced(const Model& model) const {
    Eigen::VectorXd readings(static_cast<Eigen::Index>(rows()));
    shaft_->predict(model, {readings.data(), rows()});
    return readings;
  }

  /// Of the readings by one parameter, at the values of `model`, whose parameter is left moved.
  /// Differences of second order, inside the bounds: exact but for rounding where the parameter is
  /// an amplitude, as most are.
  Eigen::VectorXd derivative(Model& model, const ModelParameter& p,
                             const Eigen::VectorXd& readings) const {
    const Stage stage = first_stage(model, steps_, p.effect);
    const double centre = p.get(model);
    const double step = (model.shaft ? shaft_step : difference_step) * typical_size(p, centre);
    const auto at = [&](double value) {
      p.set(model, value);
      if (model.shaft) return displaced(model);
      return of_rows([&](const RowPredictor& row) { return row.vary(model, steps_, stage); });
    };
    if (centre - step < p.lower)
      return (4.0 * at(centre + step) - at(centre + 2.0 * step) - 3.0 * readings) / (2.0 * step);
    if (centre + step > p.upper)
      return (3.0 * readings + at(centre - 2.0 * step) - 4.0 * at(centre - step)) / (2.0 * step);
    return (at(centre + step) - at(centre - step)) / (2.0 * step);
  }

  Model model_;
  Steps steps_;
  std::vector<ModelParameter> parameters_;
  mutable std::vector<RowPredictor> predictors_;   // one per row that can be predicted
  mutable std::optional<DisplacementRows> shaft_;  // the same, of a shaft
  std::vector<double> measured_;
  std::vector<double> own_stds_, stds_;  // of the rows; with the common scatter
  std::vector<int> lines_not_predicted_;
  bool weighted_ = false, some_std_ = false;
};

/// The residuals as Ceres sees them: parameters scaled, held ones left out.
class ScaledResiduals : public ceres::CostFunction {
 public:
  ScaledResiduals(const Residuals& residuals, Eigen::VectorXd values, Eigen::VectorXd scale,
                  std::vector<Eigen::Index> moving)
      : residuals_(residuals),
        values_(std::move(values)),
        scale_(std::move(scale)),
        moving_(std::move(moving)) {
    set_num_residuals(static_cast<int>(residuals_.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(moving_.size()));
  }

  bool Evaluate(double const* const* x, double* residual, double** jacobians) const override {
    Eigen::VectorXd values = values_;
    for (std::size_t k = 0; k < moving_.size(); ++k)
      values[moving_[k]] = x[0][k] * scale_[moving_[k]];
    const bool derivatives = jacobians != nullptr && jacobians[0] != nullptr;
    Eigen::MatrixXd full;
    const Eigen::VectorXd r = residuals_.evaluate(values, derivatives ? &full : nullptr);
    if (!r.allFinite() || !full.allFinite()) return false;
    Eigen::Map<Eigen::VectorXd>(residual, r.size()) = r;
    if (derivatives) {
      const auto columns = static_cast<Eigen::Index>(moving_.size());
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> out(
          jacobians[0], r.size(), columns);
      for (Eigen::Index k = 0; k < columns; ++k) {
        const Eigen::Index column = moving_[static_cast<std::size_t>(k)];
        out.col(k) = full.col(column) * scale_[column];
      }
    }
    return true;
  }

 private:
  const Residuals& residuals_;
  Eigen::VectorXd values_, scale_;
  std::vector<Eigen::Index> moving_;
};

/// Whether a column adds anything to those before it, and to which of them it belongs if not.
struct Dependence {
  bool dependent = false;
  std::vector<Eigen::Index> on;  // empty where the column is zero
};

std::vector<Dependence> column_dependence(const Eigen::MatrixXd& jacobian,
                                          const Eigen::VectorXd& scale) {
  std::vector<Dependence> result(static_cast<std::size_t>(jacobian.cols()));
  const double largest = (jacobian * scale.asDiagonal()).colwise().norm().maxCoeff();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    Dependence& d = result[static_cast<std::size_t>(k)];
    const double norm = jacobian.col(k).norm();
    if (!(norm * scale[k] > 1e-12 * largest)) {
      d.dependent = true;
      continue;
    }
    const Eigen::VectorXd column = jacobian.col(k) / norm;
    if (!kept.empty()) {
      Eigen::MatrixXd others(jacobian.rows(), static_cast<Eigen::Index>(kept.size()));
      for (std::size_t j = 0; j < kept.size(); ++j)
        others.col(static_cast<Eigen::Index>(j)) = jacobian.col(kept[j]).normalized();
      const Eigen::VectorXd share = others.colPivHouseholderQr().solve(column);
      if ((column - others * share).norm() < dependent) {
        d.dependent = true;
        for (std::size_t j = 0; j < kept.size(); ++j)
          if (std::abs(share[static_cast<Eigen::Index>(j)]) > 1e-3) d.on.push_back(kept[j]);
        continue;
      }
    }
    kept.push_back(k);
  }
  return result;
}

std::string with_unit(double value, const std::string& unit) {
  return unit == "1" || unit.empty() ? fmt::format("{:.5g}", value)
                                     : fmt::format("{:.5g} {}", value, unit);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

/// Marks what the data cannot tell apart, holds all but the first of a group, and says so.
void hold_dependent(const Residuals& residuals, const Eigen::VectorXd& start,
                    const Eigen::VectorXd& scale, Calibration& result) {
  // A second point, because a parameter may be without effect at its start only (the shape of an
  // effect whose size starts at zero).
  Eigen::VectorXd moved = start;
  for (Eigen::Index k = 0; k < start.size(); ++k) {
    const ModelParameter& p = residuals.parameters()[static_cast<std::size_t>(k)];
    const double step = (0.1 + 0.03 * static_cast<double>(k)) * scale[k];
    moved[k] = start[k] + step <= p.upper ? start[k] + step : std::max(start[k] - step, p.lower);
  }
  Eigen::MatrixXd jacobian;
  (void)residuals.evaluate(start, &jacobian);
  const std::vector<Dependence> here = column_dependence(jacobian, scale);
  (void)residuals.evaluate(moved, &jacobian);
  const std::vector<Dependence> there = column_dependence(jacobian, scale);
  for (std::size_t k = 0; k < here.size(); ++k) {
    if (!here[k].dependent || !there[k].dependent) continue;
    FittedParameter& p = result.parameters[k];
    p.held = true;
    p.identifiable = false;
    std::vector<std::string> group;
    for (const Eigen::Index j : there[k].on) {
      FittedParameter& other = result.parameters[static_cast<std::size_t>(j)];
      other.identifiable = false;
      group.push_back(other.name);
    }
    if (group.empty()) {
      result.messages.push_back(fmt::format("the data do not depend on {}: it stays at {}", p.name,
                                            with_unit(p.value, p.unit)));
    } else {
      group.push_back(p.name);
      result.messages.push_back(
          fmt::format("{} cannot be told apart on these data: {} is held at {}, and the other {} "
                      "without a standard error",
                      joined(group), p.name, with_unit(p.value, p.unit),
                      group.size() == 2 ? "value is" : "values are"));
    }
  }
}

Eigen::VectorXd values_of(const Calibration& result) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(result.parameters.size()));
  for (std::size_t k = 0; k < result.parameters.size(); ++k)
    values[static_cast<Eigen::Index>(k)] = result.parameters[k].value;
  return values;
}

/// Minimises from the current values. Returns the optimiser's own words on how it ended.
std::string minimise(const Residuals& residuals, const Eigen::VectorXd& scale,
                     Calibration& result) {
  std::vector<Eigen::Index> moving;
  for (Eigen::Index k = 0; k < scale.size(); ++k)
    if (!result.parameters[static_cast<std::size_t>(k)].held) moving.push_back(k);
  const Eigen::VectorXd values = values_of(result);
  std::vector<double> x;
  for (const Eigen::Index k : moving) x.push_back(values[k] / scale[k]);

  ceres::Problem problem;
  problem.AddResidualBlock(new ScaledResiduals(residuals, values, scale, moving), nullptr,
                           x.data());
  for (std::size_t m = 0; m < moving.size(); ++m) {
    const FittedParameter& p = result.parameters[static_cast<std::size_t>(moving[m])];
    const int index = static_cast<int>(m);
    if (std::isfinite(p.lower))
      problem.SetParameterLowerBound(x.data(), index, p.lower / scale[moving[m]]);
    if (std::isfinite(p.upper))
      problem.SetParameterUpperBound(x.data(), index, p.upper / scale[moving[m]]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  result.iterations += std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  result.status = summary.termination_type == ceres::CONVERGENCE      ? FitStatus::converged
                  : summary.termination_type == ceres::NO_CONVERGENCE ? FitStatus::iteration_limit
                                                                      : FitStatus::failed;
  for (std::size_t m = 0; m < moving.size(); ++m) {
    FittedParameter& p = result.parameters[static_cast<std::size_t>(moving[m])];
    const double size = scale[moving[m]];
    p.value = std::clamp(x[m] * size, p.lower, p.upper);
    p.at_bound = p.value - p.lower <= bound_tolerance * size   ? Bound::lower
                 : p.upper - p.value <= bound_tolerance * size ? Bound::upper
                                                               : Bound::none;
    if (p.at_bound != Bound::none) p.value = p.at_bound == Bound::lower ? p.lower : p.upper;
  }
  return summary.message;
}

/// The common scatter that brings χ² down to the degrees of freedom [N m] or [m]; 0 where it is
/// below.
double excess_scatter(const Residuals& residuals, const Eigen::VectorXd& errors,
                      int degrees_of_freedom) {
  if (degrees_of_freedom < 1 || residuals.chi_square(errors, 0.0) <= degrees_of_freedom) return 0.0;
  double low = 0.0, high = errors.norm();  // there χ² is below 1
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double middle = 0.5 * (low + high);
    (residuals.chi_square(errors, middle) > degrees_of_freedom ? low : high) = middle;
  }
  return high;
}

/// Fits, and where rows have standard deviations that the misfit exceeds, fits again with the
/// common scatter that explains the excess, until that stays the same.
void fit_parameters(Residuals& residuals, const Eigen::VectorXd& scale, Calibration& result) {
  const auto moving = std::count_if(result.parameters.begin(), result.parameters.end(),
                                    [](const FittedParameter& p) { return !p.held; });
  result.degrees_of_freedom = result.rows - static_cast<int>(moving);
  if (moving == 0) {
    result.status = FitStatus::nothing_to_fit;
    return;
  }
  std::string words;
  for (int round = 0; round < 50; ++round) {
    words = minimise(residuals, scale, result);
    if (!result.converged() || !residuals.weighted()) break;
    const Eigen::VectorXd errors = residuals.errors(values_of(result));
    const double before = result.excess_scatter;
    result.excess_scatter = excess_scatter(residuals, errors, result.degrees_of_freedom);
    residuals.set_excess_scatter(result.excess_scatter);
    if (result.degrees_of_freedom > 0)
      result.reduced_chi_square = residuals.chi_square(errors, 0.0) / result.degrees_of_freedom;
    if (std::abs(result.excess_scatter - before) <= 1e-6 * result.excess_scatter) break;
  }
  for (const FittedParameter& p : result.parameters)
    if (p.at_bound != Bound::none)
      result.messages.push_back(fmt::format(
          "{} ends at its {} bound, {}: the data want it beyond, or the model lacks something",
          p.name, p.at_bound == Bound::lower ? "lower" : "upper", with_unit(p.value, p.unit)));
  const QuantityText q = text_of(result.quantity);
  if (result.excess_scatter > 0.0)
    result.messages.push_back(fmt::format(
        "misfit exceeds the standard deviations of the rows (chi2/dof = {:.3g}); {:.3g} {} were "
        "added to each, by which weights are evened out and standard errors are widened",
        result.reduced_chi_square, result.excess_scatter / q.factor, q.unit));
  if (!result.converged())
    result.messages.push_back(
        fmt::format("the fit did not converge ({}): {}", name(result.status), words));
}

/// Standard errors and correlation at the solution, of the parameters that are free to move there.
void estimate_errors(const Residuals& residuals, Calibration& result) {
  const auto count = static_cast<Eigen::Index>(result.parameters.size());
  result.correlation = Eigen::MatrixXd::Constant(count, count, unset);
  Eigen::MatrixXd jacobian;
  const Eigen::VectorXd residual = residuals.evaluate(values_of(result), &jacobian);
  double factor = 1.0;  // known noise, with the excess already in the residuals
  if (!residuals.weighted()) {
    factor = result.degrees_of_freedom > 0
                 ? std::sqrt(residual.squaredNorm() / result.degrees_of_freedom)
                 : unset;
    if (result.degrees_of_freedom == 0)
      result.messages.push_back("as many rows as parameters: no standard errors");
  }

  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < count; ++k) {
    const FittedParameter& p = result.parameters[static_cast<std::size_t>(k)];
    if (!p.held && p.at_bound == Bound::none) free.push_back(k);
  }
  if (free.empty()) return;
  const auto size = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd scaled(jacobian.rows(), size);
  Eigen::VectorXd norm(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    norm[k] = jacobian.col(free[static_cast<std::size_t>(k)]).norm();
    scaled.col(k) =
        jacobian.col(free[static_cast<std::size_t>(k)]) / (norm[k] > 0.0 ? norm[k] : 1.0);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinV);
  const Eigen::VectorXd singular = svd.singularValues();
  const Eigen::MatrixXd& v = svd.matrixV();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
  std::vector<bool> lost(free.size(), false);
  for (Eigen::Index s = 0; s < size; ++s) {
    if (singular[s] > dependent * singular[0]) {
      covariance += v.col(s) * v.col(s).transpose() / (singular[s] * singular[s]);
      continue;
    }
    std::vector<std::string> group;
    for (Eigen::Index k = 0; k < size; ++k) {
      if (std::abs(v(k, s)) < 1e-3) continue;
      lost[static_cast<std::size_t>(k)] = true;
      group.push_back(
          result.parameters[static_cast<std::size_t>(free[static_cast<std::size_t>(k)])].name);
    }
    result.messages.push_back(
        fmt::format("{} cannot be told apart at the solution", joined(group)));
  }
  for (Eigen::Index k = 0; k < size; ++k) {
    FittedParameter& p =
        result.parameters[static_cast<std::size_t>(free[static_cast<std::size_t>(k)])];
    if (lost[static_cast<std::size_t>(k)] || !(norm[k] > 0.0)) p.identifiable = false;
    if (!p.identifiable) continue;
    p.std = factor * std::sqrt(covariance(k, k)) / norm[k];
    if (p.std > p.upper - p.lower) {
      result.messages.push_back(fmt::format(
          "{} is not fixed by these data: its standard error would be {}, more than the "
          "range of its bounds",
          p.name, with_unit(p.std, p.unit)));
      p.identifiable = false;
      p.std = unset;
    }
  }
  for (Eigen::Index a = 0; a < size; ++a) {
    for (Eigen::Index b = 0; b < size; ++b) {
      const Eigen::Index row = free[static_cast<std::size_t>(a)],
                         column = free[static_cast<std::size_t>(b)];
      const FittedParameter& first = result.parameters[static_cast<std::size_t>(row)];
      const FittedParameter& second = result.parameters[static_cast<std::size_t>(column)];
      if (!first.identifiable || !second.identifiable) continue;
      const double c = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
      result.correlation(row, column) = a == b ? 1.0 : c;
      if (a < b && std::abs(c) > 0.99)
        result.messages.push_back(
            fmt::format("{} and {} are correlated by {:.4f}: these data fix a combination of them "
                        "far better than "
                        "each",
                        first.name, second.name, c));
    }
  }
}

}  // namespace

std::string_view name(FitStatus status) {
  switch (status) {
    case FitStatus::not_run:
      return "not_run";
    case FitStatus::converged:
      return "converged";
    case FitStatus::iteration_limit:
      return "iteration_limit";
    case FitStatus::failed:
      return "failed";
    case FitStatus::nothing_to_fit:
      return "nothing_to_fit";
  }
  return "unknown";
}

Calibration calibrate(const Model& model, const DataSet& data) {
  require_measured_subject(model, data);
  Residuals residuals(model, data, free_parameters(model));
  Calibration result{.model = model};
  result.quantity = data.quantity;
  result.rows = static_cast<int>(residuals.rows());
  result.rows_not_predicted = residuals.lines_not_predicted();
  result.weighted = residuals.weighted();
  const std::size_t count = residuals.parameters().size();
  if (residuals.rows() < count)
    throw std::invalid_argument(fmt::format(
        "{}: {} rows can be predicted, {} parameters are free: at least as many rows as "
        "parameters are needed",
        data.source, residuals.rows(), count));
  if (!result.rows_not_predicted.empty())
    result.messages.push_back(fmt::format("{} of {} rows have no prediction and are not used",
                                          result.rows_not_predicted.size(), data.rows.size()));
  if (residuals.some_std())
    result.messages.push_back("not every row has a standard deviation: all rows weigh the same");

  Eigen::VectorXd start(static_cast<Eigen::Index>(count)), scale(start.size());
  Eigen::VectorXd given(start.size());
  for (std::size_t k = 0; k < count; ++k) {
    const ModelParameter& p = residuals.parameters()[k];
    const auto index = static_cast<Eigen::Index>(k);
    given[index] = p.get(model);
    start[index] = std::clamp(given[index], p.lower, p.upper);
    scale[index] = typical_size(p, start[index]);
    if (start[index] != given[index])
      result.messages.push_back(fmt::format("{} = {} is outside its bounds: the fit starts at {}",
                                            p.name, with_unit(given[index], p.unit),
                                            with_unit(start[index], p.unit)));
    result.parameters.push_back({.name = p.name,
                                 .unit = p.unit,
                                 .start = given[index],
                                 .value = start[index],
                                 .lower = p.lower,
                                 .upper = p.upper});
  }
  result.rmse_before = residuals.rmse(given);
  hold_dependent(residuals, start, scale, result);
  fit_parameters(residuals, scale, result);
  for (std::size_t k = 0; k < count; ++k)
    residuals.parameters()[k].set(result.model, result.parameters[k].value);
  result.rmse_after = residuals.rmse(values_of(result));
  estimate_errors(residuals, result);
  return result;
}

}  // namespace raceway::fit
