#include "shaft/fit_kinematic_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algebra/detail/decompositions.h"
#include "shaft/detail/kinematic_law_search.h"

namespace raceway::shaft {
namespace {

using record::Bound;

constexpr double gentlest = 0.01, sharpest = 100.0;  // C n_max, where no bound of C is given
constexpr double dependent = 1e-9;                   // share of a unit column that the others leave
constexpr double scatter_ratio = 1.5;      // misfit over scatter from which on a shape is left
constexpr double standstill_share = 1e-3;  // of the largest displacement, taken as zero

double squared(double x) { return x * x; }

/// What a curve gives, checked.
struct Input {
  LawRows rows;
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
      throw std::invalid_argument(
          fmt::format("std = {} um: must be above 0 and finite", p.std / um));
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
        "all displacements are 0, as for a symmetric arrangement, so there is nothing to fit");
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

LawRange checked(const KinematicLawBounds& bounds, double n_max) {
  LawRange r{bounds.lower_B, bounds.upper_B, bounds.lower_C, bounds.upper_C};
  if (std::isnan(r.lower_C)) r.lower_C = gentlest / n_max;
  if (std::isnan(r.upper_C)) r.upper_C = sharpest / n_max;
  if (!(std::isfinite(r.lower_B) && r.lower_B < r.upper_B && r.upper_B <= 1.0))
    throw std::invalid_argument(
        fmt::format("bounds of B in the kinematic law, from {} to {}: the upper bound must be "
                    "above the lower bound and at most 1",
                    r.lower_B, r.upper_B));
  if (!(r.lower_C > 0.0 && r.lower_C < r.upper_C && std::isfinite(r.upper_C)))
    throw std::invalid_argument(
        fmt::format("bounds of C in the kinematic law, from {} to {} 1/rpm: the lower bound must "
                    "be above 0, and the upper bound above the lower bound",
                    r.lower_C, r.upper_C));
  return r;
}

/// Scatter of the residuals about a smooth course, from each row's distance to the line through its
/// neighbours in speed [Gasser1986].
double scatter_of(const LawRows& rows, const std::vector<double>& residuals) {
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
void set_errors(const LawRows& rows, double cost, KinematicLawFit& fit) {
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
    record::Parameter& p = fit.parameters[static_cast<std::size_t>(k)];
    p.identifiable = all.col(k).norm() > 0.0;  // C of a straight line, where B is 0
    if (p.identifiable && p.at_bound == Bound::none) moved.push_back(k);
  }
  Eigen::MatrixXd jacobian = all(Eigen::all, moved);
  const Eigen::RowVectorXd norms = jacobian.colwise().norm();
  jacobian.array().rowwise() /= norms.array();
  if (algebra::PivotedQr(jacobian, dependent).rank() < jacobian.cols()) {
    for (const Eigen::Index k : moved)
      fit.parameters[static_cast<std::size_t>(k)].identifiable = false;
    return;
  }
  const double reduced = cost / static_cast<double>(count - jacobian.cols());
  const double variance = fit.weighted ? std::max(1.0, reduced) : reduced;
  const Eigen::MatrixXd inverse = algebra::inverse(jacobian.transpose() * jacobian);
  for (Eigen::Index k = 0; k < inverse.rows(); ++k) {
    const Eigen::Index p = moved[static_cast<std::size_t>(k)];
    fit.parameters[static_cast<std::size_t>(p)].std =
        std::sqrt(variance * inverse(k, k)) / norms[k];
    for (Eigen::Index j = 0; j < inverse.cols(); ++j)
      fit.correlation(p, moved[static_cast<std::size_t>(j)]) =
          inverse(k, j) / std::sqrt(inverse(k, k) * inverse(j, j));
  }
}

KinematicLawFit finished(const Input& in, const LawRange& range, const LawOptimum& optimum) {
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
      record::Parameter{.name = "A", .unit = "um", .value = A, .lower = -endless, .upper = endless},
      record::Parameter{.name = "B",
                        .unit = "1",
                        .value = B,
                        .lower = range.lower_B,
                        .upper = range.upper_B,
                        .at_bound = bound_of(B, range.lower_B, range.upper_B)},
      record::Parameter{
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
  for (const record::Parameter& p : fit.parameters) {
    if (p.at_bound != Bound::none)
      fit.notes.push_back(record::note::at_bound(
          fmt::format("{} is at its {} bound {:.4g}", p.name,
                      p.at_bound == Bound::lower ? "lower" : "upper", p.value),
          {.key = std::string(p.name)}));
    if (!p.identifiable)
      fit.notes.push_back(record::note::not_identifiable(
          fmt::format("{} is not determined by these rows", p.name), {.key = std::string(p.name)}));
  }
  if (std::abs(fit.standstill) > standstill_share * fit.largest)
    fit.notes.push_back(
        record::note::check_data(fmt::format("the displacement at standstill is {:.4g} um, but the "
                                             "law gives 0: subtract this value from all rows",
                                             fit.standstill / um)));
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
  const LawRange range = checked(bounds, in.rows.n.back());
  KinematicLawFit fit = finished(in, range, best_optimum(in.rows, range));
  add_notes(fit);
  return fit;
}

KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                     const KinematicLaw& start, const KinematicLawBounds& bounds) {
  const Input in = checked(curve);
  const LawRange range = checked(bounds, in.rows.n.back());
  KinematicLawFit fit = finished(in, range, nearest_optimum(in.rows, range, {start.B, start.C}));
  add_notes(fit);
  return fit;
}

}  // namespace raceway::shaft
