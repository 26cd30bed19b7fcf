#include "fit/fit_kinematic_law.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <stdexcept>

namespace raceway::fit {
namespace {

constexpr double gentlest = 0.01, sharpest = 100.0;  // C n_max, where no bound of C is given
constexpr std::size_t grid_rows = 200;               // rows that the search on the grid looks at
constexpr int grid_of_C = 60, grid_of_B = 40;
constexpr double bound_tolerance = 1e-7;   // of the range of B, of C
constexpr double dependent = 1e-9;         // share of a unit column that the others leave
constexpr double scatter_ratio = 1.5;      // misfit over scatter from which on a shape is left
constexpr double standstill_share = 1e-3;  // of the largest displacement, taken as zero

double squared(double x) { return x * x; }

/// The rows that are fitted, in the units of the law, by increasing speed.
struct Rows {
  std::vector<double> n, log_n, u, weight;
};

struct Shape {
  double B, C;
};

/// The curves of one C without their size, n^(1 - B exp(-C n)) over its value at the highest speed.
class Forms {
 public:
  Forms(const Rows& rows, double C) : rows_(rows) {
    const double log_end = rows.log_n.back(), bend_end = std::exp(-C * rows.n.back()) * log_end;
    for (std::size_t i = 0; i < rows.n.size(); ++i) {
      straight_.push_back(rows.log_n[i] - log_end);
      bend_.push_back(std::exp(-C * rows.n[i]) * rows.log_n[i] - bend_end);
    }
  }

  /// Displacement at the highest speed by which a form is best multiplied, and what it leaves.
  struct Projection {
    double size, cost;
  };
  [[nodiscard]] Projection project(double B) const {
    Sums sums;
    for (std::size_t i = 0; i < bend_.size(); ++i)
      sums.add(rows_, i, std::exp(straight_[i] - B * bend_[i]));
    return sums.projection();
  }

  /// Costs at `count` equal steps of B; powers of one factor save the exponentials.
  [[nodiscard]] std::vector<double> costs(double first, double step, int count) const {
    std::vector<double> form, factor, result;
    for (std::size_t i = 0; i < bend_.size(); ++i) {
      form.push_back(std::exp(straight_[i] - first * bend_[i]));
      factor.push_back(std::exp(-step * bend_[i]));
    }
    for (int k = 0; k < count; ++k) {
      Sums sums;
      for (std::size_t i = 0; i < form.size(); ++i) {
        sums.add(rows_, i, form[i]);
        form[i] *= factor[i];
      }
      result.push_back(sums.projection().cost);
    }
    return result;
  }

 private:
  struct Sums {
    double ff = 0.0, fu = 0.0, uu = 0.0;
    void add(const Rows& rows, std::size_t i, double form) {
      const double w = squared(rows.weight[i]);
      ff += w * form * form;
      fu += w * form * rows.u[i];
      uu += w * rows.u[i] * rows.u[i];
    }
    [[nodiscard]] Projection projection() const { return {fu / ff, uu - fu * fu / ff}; }
  };
  const Rows& rows_;
  std::vector<double> straight_, bend_;
};

struct Range {
  double lower_B, upper_B, lower_C, upper_C;
};

/// The best B at each C of a grid, and of these the minima along C.
std::vector<Shape> minima_on_grid(const Rows& all, const Range& range) {
  Rows rows;
  const std::size_t count = std::min(grid_rows, all.n.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count == 1 ? 0 : k * (all.n.size() - 1) / (count - 1);
    rows.n.push_back(all.n[i]);
    rows.log_n.push_back(all.log_n[i]);
    rows.u.push_back(all.u[i]);
    rows.weight.push_back(all.weight[i]);
  }
  std::vector<Shape> best;
  std::vector<double> costs;
  const double step_B = (range.upper_B - range.lower_B) / grid_of_B;
  for (int j = 0; j <= grid_of_C; ++j) {
    const double C =
        range.lower_C * std::pow(range.upper_C / range.lower_C, static_cast<double>(j) / grid_of_C);
    const Forms forms(rows, C);
    const auto cost = [&](double B) { return forms.project(B).cost; };
    const std::vector<double> by_B = forms.costs(range.lower_B, step_B, grid_of_B + 1);
    const auto low = std::min_element(by_B.begin(), by_B.end());
    const double lowest = *low;
    const double at = range.lower_B + static_cast<double>(low - by_B.begin()) * step_B;
    const auto [B, value] = boost::math::tools::brent_find_minima(
        cost, std::max(range.lower_B, at - step_B), std::min(range.upper_B, at + step_B), 20);
    best.push_back({value < lowest ? B : at, C});
    costs.push_back(std::min(value, lowest));
  }
  std::vector<Shape> minima;
  for (std::size_t j = 0; j < best.size(); ++j)
    if ((j == 0 || costs[j] <= costs[j - 1]) && (j + 1 == best.size() || costs[j] <= costs[j + 1]))
      minima.push_back(best[j]);
  return minima;
}

/// Law minus reading for Ceres. Unknowns of order one that hardly depend on each other: the
/// displacement at the highest speed over the largest reading, B, and ln C.
class LawResiduals {
 public:
  LawResiduals(const Rows& rows, double scale) : rows_(rows), scale_(scale) {}

  template <typename T>
  bool operator()(const T* x, T* residual) const {
    using std::exp;
    const T C = exp(x[2]);
    const double end = rows_.n.back(), log_end = rows_.log_n.back();
    const T exponent_end = (1.0 - x[1] * exp(-C * end)) * log_end;
    for (std::size_t i = 0; i < rows_.n.size(); ++i) {
      const T exponent = (1.0 - x[1] * exp(-C * rows_.n[i])) * rows_.log_n[i];
      residual[i] = rows_.weight[i] * (x[0] * exp(exponent - exponent_end) - rows_.u[i] / scale_);
    }
    return true;
  }

 private:
  const Rows& rows_;
  double scale_;
};

struct Optimum {
  double size = unset;  ///< displacement at the highest speed [um]
  Shape shape{unset, unset};
  double cost = std::numeric_limits<double>::infinity();
  int iterations = 0;
  FitStatus status = FitStatus::failed;
};

Bound bound_of(double value, double lower, double upper) {
  const double near = bound_tolerance * (upper - lower);
  return value - lower <= near ? Bound::lower : upper - value <= near ? Bound::upper : Bound::none;
}

class Minimisation {
 public:
  Minimisation(const Rows& rows, const Range& range)
      : rows_(rows),
        scale_(*std::max_element(rows.u.begin(), rows.u.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); })),
        lower_{range.lower_B, std::log(range.lower_C)},
        upper_{range.upper_B, std::log(range.upper_C)} {}

  [[nodiscard]] Optimum from(const Shape& start) const {
    std::array x{0.0, std::clamp(start.B, lower_[0], upper_[0]),
                 std::clamp(std::log(start.C), lower_[1], upper_[1])};
    x[0] = Forms(rows_, std::exp(x[2])).project(x[1]).size / scale_;
    Optimum optimum;
    run(x, {}, optimum);
    // Along a bound the optimiser's steps are cut short and it stops early: hold what has arrived
    // there and go on with the rest.
    std::vector<int> held;
    for (int k = 1; k <= 2; ++k) {
      double& value = x[static_cast<std::size_t>(k)];
      const double lower = lower_[static_cast<std::size_t>(k - 1)];
      const double upper = upper_[static_cast<std::size_t>(k - 1)];
      const Bound bound = bound_of(value, lower, upper);
      if (bound == Bound::none) continue;
      value = bound == Bound::lower ? lower : upper;
      held.push_back(k);
    }
    if (!held.empty()) run(x, held, optimum);
    return optimum;
  }

 private:
  void run(std::array<double, 3>& x, const std::vector<int>& held, Optimum& optimum) const {
    ceres::Problem problem;
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<LawResiduals, ceres::DYNAMIC, 3>(
                                 new LawResiduals(rows_, scale_), static_cast<int>(rows_.n.size())),
                             nullptr, x.data());
    for (int k = 0; k < 2; ++k) {
      problem.SetParameterLowerBound(x.data(), k + 1, lower_[static_cast<std::size_t>(k)]);
      problem.SetParameterUpperBound(x.data(), k + 1, upper_[static_cast<std::size_t>(k)]);
    }
    if (!held.empty()) problem.SetManifold(x.data(), new ceres::SubsetManifold(3, held));
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.max_num_iterations = 500;
    options.function_tolerance = 1e-16;
    options.gradient_tolerance = 1e-15;
    options.parameter_tolerance = 1e-13;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    optimum.size = x[0] * scale_;
    optimum.shape = {std::clamp(x[1], lower_[0], upper_[0]), std::exp(x[2])};
    optimum.cost = 2.0 * summary.final_cost * squared(scale_);
    optimum.iterations += std::max(0, static_cast<int>(summary.iterations.size()) - 1);
    optimum.status = summary.termination_type == ceres::CONVERGENCE ? FitStatus::converged
                     : summary.termination_type == ceres::NO_CONVERGENCE
                         ? FitStatus::iteration_limit
                         : FitStatus::failed;
  }

  const Rows& rows_;
  double scale_;
  std::array<double, 2> lower_, upper_;  // of B and ln C
};

/// What a curve gives, checked.
struct Input {
  Rows rows;
  double lowest_speed = 0.0, highest_speed = 0.0;  // [rad/s]
  double largest = 0.0;                            // [um]
  double standstill = 0.0;                         // largest reading there [um]
  int rows_at_standstill = 0;
  bool weighted = false;
};

Input checked(std::span<const DisplacementPoint> curve) {
  std::vector<DisplacementPoint> points;
  Input in;
  in.weighted = !curve.empty();
  for (const DisplacementPoint& p : curve) {
    if (!std::isfinite(p.speed) || p.speed < 0.0)
      throw std::invalid_argument(
          fmt::format("speed = {} rpm: must be finite and not negative", p.speed / rpm));
    if (!std::isfinite(p.displacement))
      throw std::invalid_argument(
          fmt::format("displacement = {} um: must be finite", p.displacement / um));
    if (!std::isnan(p.std) && !(p.std > 0.0 && std::isfinite(p.std)))
      throw std::invalid_argument(fmt::format("std = {} um: must be positive", p.std / um));
    in.weighted = in.weighted && !std::isnan(p.std);
    in.largest = std::max(in.largest, std::abs(p.displacement) / um);
    if (p.speed > 0.0) {
      points.push_back(p);
    } else {
      ++in.rows_at_standstill;
      if (std::abs(p.displacement) / um > std::abs(in.standstill))
        in.standstill = p.displacement / um;
    }
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.speed < b.speed; });
  int speeds = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    speeds += i == 0 || points[i].speed > points[i - 1].speed ? 1 : 0;
  if (speeds < 4)
    throw std::invalid_argument(
        fmt::format("{} different speed{} above zero: the law has three parameters and needs at "
                    "least 4",
                    speeds, speeds == 1 ? "" : "s"));
  if (std::all_of(points.begin(), points.end(),
                  [](const auto& p) { return p.displacement == 0.0; }))
    throw std::invalid_argument(
        "all displacements are 0: nothing to fit (a symmetric set does not move)");
  in.lowest_speed = in.rows_at_standstill > 0 ? 0.0 : points.front().speed;
  in.highest_speed = points.back().speed;
  for (const DisplacementPoint& p : points) {
    in.rows.n.push_back(p.speed / rpm);
    in.rows.log_n.push_back(std::log(in.rows.n.back()));
    in.rows.u.push_back(p.displacement / um);
    in.rows.weight.push_back(in.weighted ? um / p.std : 1.0);
  }
  return in;
}

Range checked(const KinematicLawBounds& bounds, double n_max) {
  Range r{bounds.lower_B, bounds.upper_B, bounds.lower_C, bounds.upper_C};
  if (std::isnan(r.lower_C)) r.lower_C = gentlest / n_max;
  if (std::isnan(r.upper_C)) r.upper_C = sharpest / n_max;
  if (!(std::isfinite(r.lower_B) && r.lower_B < r.upper_B && r.upper_B <= 1.0))
    throw std::invalid_argument(
        fmt::format("bounds of B from {} to {}: must increase, up to 1", r.lower_B, r.upper_B));
  if (!(r.lower_C > 0.0 && r.lower_C < r.upper_C && std::isfinite(r.upper_C)))
    throw std::invalid_argument(fmt::format(
        "bounds of C from {} to {} 1/rpm: must increase, from above 0", r.lower_C, r.upper_C));
  return r;
}

/// Scatter of the residuals about a smooth course, from each row's distance to the line through its
/// neighbours in speed (Gasser, Sroka and Jennen-Steinmetz 1986).
double scatter_of(const Rows& rows, const std::vector<double>& residuals) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < residuals.size(); ++i) {
    const double width = rows.n[i + 1] - rows.n[i - 1];
    const double b = width > 0.0 ? (rows.n[i] - rows.n[i - 1]) / width : 0.5;
    const double a = 1.0 - b;
    sum +=
        squared(a * residuals[i - 1] + b * residuals[i + 1] - residuals[i]) / (a * a + b * b + 1.0);
  }
  return std::sqrt(sum / static_cast<double>(residuals.size() - 2));
}

/// Standard errors and correlations of the parameters that are not at a bound.
void set_errors(const Rows& rows, double cost, KinematicLawFit& fit) {
  const auto count = static_cast<Eigen::Index>(rows.n.size());
  const KinematicLaw& law = fit.law;
  Eigen::MatrixXd all(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const double n = rows.n[row];
    const double u = kinematic_displacement_um(n, law.A, law.B, law.C);
    const double by_B = -u * std::exp(-law.C * n) * rows.log_n[row];
    all.row(i) = rows.weight[row] * Eigen::RowVector3d(u / law.A, by_B, -law.B * n * by_B);
  }
  std::vector<Eigen::Index> moved;
  for (Eigen::Index k = 0; k < 3; ++k) {
    FittedParameter& p = fit.parameters[static_cast<std::size_t>(k)];
    p.identifiable = all.col(k).norm() > 0.0;  // C of a straight line, where B is 0
    if (p.identifiable && p.at_bound == Bound::none) moved.push_back(k);
  }
  Eigen::MatrixXd jacobian = all(Eigen::all, moved);
  const Eigen::RowVectorXd norms = jacobian.colwise().norm();
  jacobian.array().rowwise() /= norms.array();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian.rows(), jacobian.cols());
  qr.setThreshold(dependent);
  qr.compute(jacobian);
  if (qr.rank() < jacobian.cols()) {
    for (const Eigen::Index k : moved)
      fit.parameters[static_cast<std::size_t>(k)].identifiable = false;
    return;
  }
  const double reduced = cost / static_cast<double>(count - jacobian.cols());
  const double variance = fit.weighted ? std::max(1.0, reduced) : reduced;
  const Eigen::MatrixXd inverse = (jacobian.transpose() * jacobian).inverse();
  for (Eigen::Index k = 0; k < inverse.rows(); ++k) {
    const Eigen::Index p = moved[static_cast<std::size_t>(k)];
    fit.parameters[static_cast<std::size_t>(p)].std =
        std::sqrt(variance * inverse(k, k)) / norms[k];
    for (Eigen::Index j = 0; j < inverse.cols(); ++j)
      fit.correlation(p, moved[static_cast<std::size_t>(j)]) =
          inverse(k, j) / std::sqrt(inverse(k, k) * inverse(j, j));
  }
}

KinematicLawFit finished(const Input& in, const Range& range, const Optimum& optimum) {
  KinematicLawFit fit;
  const auto& [B, C] = optimum.shape;
  fit.status = optimum.status;
  fit.iterations = optimum.iterations;
  fit.weighted = in.weighted;
  fit.rows = static_cast<int>(in.rows.n.size());
  fit.rows_at_standstill = in.rows_at_standstill;
  fit.standstill = in.standstill * um;
  fit.largest = in.largest * um;
  const double end = in.rows.n.back();
  const double A = optimum.size / kinematic_displacement_um(end, 1.0, B, C);
  fit.law = {A, B, C, in.lowest_speed, in.highest_speed};
  constexpr double endless = std::numeric_limits<double>::infinity();
  fit.parameters = {
      FittedParameter{.name = "A", .unit = "um", .value = A, .lower = -endless, .upper = endless},
      FittedParameter{.name = "B",
                      .unit = "1",
                      .value = B,
                      .lower = range.lower_B,
                      .upper = range.upper_B,
                      .at_bound = bound_of(B, range.lower_B, range.upper_B)},
      FittedParameter{
          .name = "C",
          .unit = "1/rpm",
          .value = C,
          .lower = range.lower_C,
          .upper = range.upper_C,
          .at_bound = bound_of(std::log(C), std::log(range.lower_C), std::log(range.upper_C))}};
  std::vector<double> residuals;
  double absolute = 0.0, largest = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < in.rows.n.size(); ++i) {
    const double r = kinematic_displacement_um(in.rows.n[i], A, B, C) - in.rows.u[i];
    residuals.push_back(r);
    absolute += std::abs(r);
    squares += r * r;
    if (std::abs(r) >= largest) {
      largest = std::abs(r);
      fit.speed_of_max_abs = in.rows.n[i] * rpm;
    }
  }
  const auto count = static_cast<double>(fit.rows);
  fit.mae = absolute / count * um;
  fit.max_abs = largest * um;
  fit.misfit = std::sqrt(optimum.cost / count) * (in.weighted ? 1.0 : um);
  fit.scatter = scatter_of(in.rows, residuals) * um;
  set_errors(in.rows, optimum.cost, fit);
  const bool within =
      fit.mae <= kinematic_law_tolerance && fit.mae <= kinematic_law_share * fit.largest;
  const double rms = std::sqrt(squares / count) * um;
  fit.verdict = within                               ? KinematicLawVerdict::follows
                : rms <= scatter_ratio * fit.scatter ? KinematicLawVerdict::scatter
                                                     : KinematicLawVerdict::stiff;
  return fit;
}

void add_notes(KinematicLawFit& fit) {
  for (const FittedParameter& p : fit.parameters) {
    if (p.at_bound != Bound::none)
      fit.notes.push_back(fmt::format("{} is at its {} bound {:.4g}", p.name,
                                      p.at_bound == Bound::lower ? "lower" : "upper", p.value));
    if (!p.identifiable)
      fit.notes.push_back(fmt::format("{} is not determined by these rows", p.name));
  }
  if (std::abs(fit.standstill) > standstill_share * fit.largest)
    fit.notes.push_back(fmt::format(
        "the displacement at standstill is {:.4g} um, that of the law 0: take it off all rows, or "
        "the law has to bend to it",
        fit.standstill / um));
}

}  // namespace

std::string_view name(KinematicLawVerdict verdict) {
  switch (verdict) {
    case KinematicLawVerdict::follows:
      return "follows";
    case KinematicLawVerdict::scatter:
      return "scatter";
    case KinematicLawVerdict::stiff:
      break;
  }
  return "stiff";
}

KinematicLawFit fit_kinematic_law(std::span<const DisplacementPoint> curve,
                                  const KinematicLawBounds& bounds) {
  const Input in = checked(curve);
  const Range range = checked(bounds, in.rows.n.back());
  const Minimisation minimisation(in.rows, range);
  Optimum best;
  for (const Shape& start : minima_on_grid(in.rows, range))
    if (const Optimum end = minimisation.from(start); end.cost < best.cost) best = end;
  KinematicLawFit fit = finished(in, range, best);
  add_notes(fit);
  return fit;
}

KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                     const KinematicLaw& start, const KinematicLawBounds& bounds) {
  const Input in = checked(curve);
  const Range range = checked(bounds, in.rows.n.back());
  KinematicLawFit fit = finished(in, range, Minimisation(in.rows, range).from({start.B, start.C}));
  add_notes(fit);
  return fit;
}

}  // namespace raceway::fit
