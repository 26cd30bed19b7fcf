#include "shaft/detail/kinematic_law_search.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace raceway::shaft {
namespace {

using fit::FitStatus;
using record::Bound;

constexpr std::size_t grid_rows = 200;  // rows that the search on the grid looks at
constexpr int grid_of_C = 60, grid_of_B = 40;
constexpr double bound_tolerance = 1e-7;  // of the range of B, of ln C
constexpr double flat_gradient = 1e-9;    // of residuals of order one

double square_of(double x) { return x * x; }

/// The curves of one C without their size, n^(1 - B exp(-C n)) over its value at the highest speed.
class Forms {
 public:
  Forms(const LawRows& rows, double C) : rows_(rows) {
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
    void add(const LawRows& rows, std::size_t i, double form) {
      const double w = square_of(rows.weight[i]);
      ff += w * form * form;
      fu += w * form * rows.u[i];
      uu += w * rows.u[i] * rows.u[i];
    }
    [[nodiscard]] Projection projection() const { return {fu / ff, uu - fu * fu / ff}; }
  };
  const LawRows& rows_;
  std::vector<double> straight_, bend_;
};

/// The best B at each C of a grid, and of these the minima along C.
std::vector<LawShape> minima_on_grid(const LawRows& all, const LawRange& range) {
  LawRows rows;
  const std::size_t count = std::min(grid_rows, all.n.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count == 1 ? 0 : k * (all.n.size() - 1) / (count - 1);
    rows.n.push_back(all.n[i]);
    rows.log_n.push_back(all.log_n[i]);
    rows.u.push_back(all.u[i]);
    rows.weight.push_back(all.weight[i]);
  }
  std::vector<LawShape> best;
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
  std::vector<LawShape> minima;
  for (std::size_t j = 0; j < best.size(); ++j)
    if ((j == 0 || costs[j] <= costs[j - 1]) && (j + 1 == best.size() || costs[j] <= costs[j + 1]))
      minima.push_back(best[j]);
  return minima;
}

/// Law minus reading for Ceres. Unknowns of order one that hardly depend on each other: the
/// displacement at the highest speed over the largest reading, B, and ln C.
class LawResiduals {
 public:
  LawResiduals(const LawRows& rows, double scale, double largest_weight)
      : rows_(rows), scale_(scale), largest_weight_(largest_weight) {}

  template <typename T>
  bool operator()(const T* x, T* residual) const {
    using std::exp;
    const T C = exp(x[2]);
    const double end = rows_.n.back(), log_end = rows_.log_n.back();
    const T exponent_end = (1.0 - x[1] * exp(-C * end)) * log_end;
    for (std::size_t i = 0; i < rows_.n.size(); ++i) {
      const T exponent = (1.0 - x[1] * exp(-C * rows_.n[i])) * rows_.log_n[i];
      residual[i] = rows_.weight[i] / largest_weight_ *
                    (x[0] * exp(exponent - exponent_end) - rows_.u[i] / scale_);
    }
    return true;
  }

 private:
  const LawRows& rows_;
  double scale_, largest_weight_;
};

class Minimisation {
 public:
  Minimisation(const LawRows& rows, const LawRange& range)
      : rows_(rows),
        scale_(*std::max_element(rows.u.begin(), rows.u.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); })),
        largest_weight_(*std::max_element(rows.weight.begin(), rows.weight.end())),
        lower_{range.lower_B, std::log(range.lower_C)},
        upper_{range.upper_B, std::log(range.upper_C)} {}

  [[nodiscard]] LawOptimum from(const LawShape& start) const {
    std::array x{0.0, std::clamp(start.B, lower_[0], upper_[0]),
                 std::clamp(std::log(start.C), lower_[1], upper_[1])};
    x[0] = Forms(rows_, std::exp(x[2])).project(x[1]).size / scale_;
    LawOptimum optimum;
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
    // A straight line has no C.
    if (x[1] == 0.0 && held.size() == 1) held = {1, 2};
    if (!held.empty()) run(x, held, optimum);
    return optimum;
  }

 private:
  void run(std::array<double, 3>& x, const std::vector<int>& held, LawOptimum& optimum) const {
    ceres::Problem problem;
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<LawResiduals, ceres::DYNAMIC, 3>(
            new LawResiduals(rows_, scale_, largest_weight_), static_cast<int>(rows_.n.size())),
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
    options.function_tolerance = 1e-14;
    options.gradient_tolerance = 1e-15;
    options.parameter_tolerance = 1e-13;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    optimum.size = x[0] * scale_;
    optimum.shape = {std::clamp(x[1], lower_[0], upper_[0]), std::exp(x[2])};
    optimum.cost = 2.0 * summary.final_cost * square_of(scale_ * largest_weight_);
    optimum.iterations += std::max(0, static_cast<int>(summary.iterations.size()) - 1);
    // Where steps sink below rounding Ceres calls it a failure; the gradient knows better.
    const bool flat =
        !summary.iterations.empty() && summary.iterations.back().gradient_max_norm < flat_gradient;
    optimum.status = summary.termination_type == ceres::CONVERGENCE || flat ? FitStatus::converged
                     : summary.termination_type == ceres::NO_CONVERGENCE
                         ? FitStatus::iteration_limit
                         : FitStatus::failed;
  }

  const LawRows& rows_;
  double scale_, largest_weight_;
  std::array<double, 2> lower_, upper_;  // of B and ln C
};

}  // namespace

LawOptimum nearest_optimum(const LawRows& rows, const LawRange& range, const LawShape& start) {
  return Minimisation(rows, range).from(start);
}

LawOptimum best_optimum(const LawRows& rows, const LawRange& range) {
  const Minimisation minimisation(rows, range);
  LawOptimum best;
  for (const LawShape& start : minima_on_grid(rows, range))
    if (const LawOptimum end = minimisation.from(start); end.cost < best.cost) best = end;
  return best;
}

Bound bound_of(double value, double lower, double upper) {
  const double near = bound_tolerance * (upper - lower);
  return value - lower <= near ? Bound::lower : upper - value <= near ? Bound::upper : Bound::none;
}

}  // namespace raceway::shaft
