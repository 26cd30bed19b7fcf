#include "spindle/step_fit.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algebra/detail/decompositions.h"

namespace raceway::spindle {
namespace {

constexpr double shortest_of_first = 0.1;  // time constant over the first time
constexpr double longest_of_last = 30.0;   // and over the last one
constexpr int grid_points = 48;
constexpr double least_ratio = 1.2;  // of two time constants, below which they are one
constexpr int most_steps = 100;
constexpr double settled_at = 1e-11;  // change of a logarithm
constexpr double share_that_matters = 0.01;
constexpr double gain_of_two = 0.5;
constexpr Eigen::Index rows_for_two = 6;
// A decay is sought on this many points for each lag; the grid then closes in.
constexpr Eigen::Index decay_grid = 33;
constexpr double decay_narrows = 0.4, decay_resolution = 1e-7;

double decay_place(double middle, double half, Eigen::Index k) {
  return middle + half * (2.0 * static_cast<double>(k) / (decay_grid - 1) - 1.0);
}

/// A step at its times, as sums of lags with given logarithms of time constants.
class ProjectedStep {
 public:
  ProjectedStep(std::span<const double> time, std::span<const double> displacement)
      : time_(Eigen::Map<const Eigen::VectorXd>(time.data(), Eigen::Index(time.size()))),
        measured_(Eigen::Map<const Eigen::VectorXd>(displacement.data(),
                                                    Eigen::Index(displacement.size()))) {}

  struct Point {
    Eigen::VectorXd log_time, gain, left;
    double misfit = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] Eigen::VectorXd column(double log_time) const {
    const double rate = std::exp(-log_time);
    return time_.unaryExpr([&](double t) { return -std::expm1(-t * rate); });
  }

  [[nodiscard]] Point at(const Eigen::VectorXd& log_time) const {
    Point p{.log_time = log_time, .gain = {}, .left = {}};
    const Eigen::MatrixXd columns = columns_of(log_time);
    const algebra::PivotedQr qr(columns);
    if (qr.rank() < columns.cols()) return p;
    p.gain = qr.solve(measured_);
    p.left = measured_ - columns * p.gain;
    p.misfit = p.left.squaredNorm();
    return p;
  }

  /// The nearest minimum, within bounds of logarithms that keep two of them apart.
  [[nodiscard]] Point refined(Point best, double lower, double upper) const {
    double damping = 1e-6;
    for (int step = 0; step < most_steps && damping < 1e12; ++step) {
      const Eigen::MatrixXd slope = slopes(best);
      const Eigen::MatrixXd square = slope.transpose() * slope;
      Eigen::MatrixXd damped = square;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd move = algebra::solve_symmetric(damped, slope.transpose() * best.left);
      if (!move.allFinite()) break;
      const Eigen::VectorXd to = (best.log_time + move).cwiseMax(lower).cwiseMin(upper);
      const bool apart = to.size() < 2 || to(1) - to(0) >= std::log(least_ratio);
      const Point next = apart ? at(to) : Point{};
      if (next.misfit <= best.misfit) {
        const double moved = (to - best.log_time).cwiseAbs().maxCoeff();
        best = next;
        damping = std::max(damping * 0.1, 1e-12);
        if (moved < settled_at) break;
      } else {
        damping *= 10.0;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Eigen::MatrixXd columns_of(const Eigen::VectorXd& log_time) const {
    Eigen::MatrixXd columns(time_.size(), log_time.size());
    for (Eigen::Index k = 0; k < log_time.size(); ++k) columns.col(k) = column(log_time(k));
    return columns;
  }

  /// What the prediction gains with each logarithm while gains follow: the derivatives of its
  /// columns less what the columns themselves make of them (Kaufman).
  ///
  ///   d(1 - exp(-t/T))/d ln T = -(t/T) exp(-t/T)
  [[nodiscard]] Eigen::MatrixXd slopes(const Point& p) const {
    const Eigen::MatrixXd columns = columns_of(p.log_time);
    Eigen::MatrixXd slope(time_.size(), p.log_time.size());
    for (Eigen::Index k = 0; k < p.log_time.size(); ++k) {
      const double rate = std::exp(-p.log_time(k)), gain = p.gain(k);
      slope.col(k) =
          time_.unaryExpr([&](double t) { return -gain * t * rate * std::exp(-t * rate); });
    }
    return slope - columns * algebra::PivotedQr(columns).solve(slope);
  }

  Eigen::VectorXd time_, measured_;
};

void check_step(std::span<const double> time, std::span<const double> displacement) {
  if (time.size() != displacement.size())
    throw std::invalid_argument(
        fmt::format("number of times: {}, number of displacements: {}; both numbers must be equal",
                    time.size(), displacement.size()));
  double first = std::numeric_limits<double>::infinity(), last = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!std::isfinite(time[k]) || time[k] < 0.0)
      throw std::invalid_argument(
          fmt::format("time = {:.6g} s: must be 0 s (the time of the step) or later", time[k]));
    if (!std::isfinite(displacement[k]))
      throw std::invalid_argument(
          fmt::format("displacement at {:.6g} s: must be a number", time[k]));
    if (time[k] == 0.0) continue;
    first = std::min(first, time[k]);
    last = std::max(last, time[k]);
    largest = std::max(largest, std::abs(displacement[k]));
  }
  if (!(last > first))
    throw std::invalid_argument("a step response needs rows at two or more times after 0 s");
  if (largest == 0.0)
    throw std::invalid_argument("the displacement is 0 at all times: there is no step response");
}

double rms_of(const ProjectedStep::Point& p) {
  return std::sqrt(p.misfit / static_cast<double>(p.left.size()));
}

/// From a tenth of the first time after 0 to thirty times the last, as logarithms.
std::pair<double, double> log_bounds(std::span<const double> time) {
  double first = std::numeric_limits<double>::infinity(), last = 0.0;
  for (const double t : time) {
    if (t == 0.0) continue;
    first = std::min(first, t);
    last = std::max(last, t);
  }
  return {std::log(shortest_of_first * first), std::log(longest_of_last * last)};
}

}  // namespace

double displacement_at(const Lag& lag, double time) {
  return -lag.gain * std::expm1(-time / lag.time_constant);
}

StepFit fit_step(std::span<const double> time, std::span<const double> displacement) {
  check_step(time, displacement);
  const auto [lower, upper] = log_bounds(time);
  const double width = upper - lower, begin = lower;
  const auto of_grid = [&](int k) { return begin + width * k / (grid_points - 1); };
  const ProjectedStep step(time, displacement);

  ProjectedStep::Point one, two;
  for (int i = 0; i < grid_points; ++i)
    if (auto p = step.at(Eigen::VectorXd::Constant(1, of_grid(i))); p.misfit < one.misfit) one = p;
  one = step.refined(one, lower, upper);

  StepFit fit{.one = {one.gain(0), std::exp(one.log_time(0))}, .rms = rms_of(one)};
  fit.settled = *std::max_element(time.begin(), time.end()) >= 2.0 * fit.one.time_constant;
  const auto moving = std::count_if(time.begin(), time.end(), [](double t) { return t > 0.0; });
  if (moving < rows_for_two) return fit;
  for (int i = 0; i < grid_points; ++i)
    for (int j = i + 1; j < grid_points; ++j)
      if (auto p = step.at(Eigen::Vector2d(of_grid(i), of_grid(j))); p.misfit < two.misfit) two = p;
  if (two.gain.size() == 0) return fit;
  two = step.refined(two, lower, upper);
  fit.fast = {two.gain(0), std::exp(two.log_time(0))};
  fit.slow = {two.gain(1), std::exp(two.log_time(1))};
  fit.rms_of_two = rms_of(two);
  fit.two_needed = fit.rms > share_that_matters * std::abs(fit.one.gain) &&
                   fit.rms_of_two < gain_of_two * fit.rms;
  return fit;
}

std::vector<double> fit_decay(std::span<const double> time, std::span<const double> displacement,
                              std::span<const double> gains) {
  check_step(time, displacement);
  if (gains.empty() || gains.size() > 2)
    throw std::invalid_argument(
        "gains: give one gain for each lag of the decay; the decay can have one or two lags");
  const Eigen::Map<const Eigen::VectorXd> t(time.data(), static_cast<Eigen::Index>(time.size())),
      u(displacement.data(), static_cast<Eigen::Index>(displacement.size()));
  const auto [lower, upper] = log_bounds(time);
  Eigen::Vector2d best(0.5 * (lower + upper), 0.5 * (lower + upper));
  for (double half = 0.5 * (upper - lower); half > decay_resolution; half *= decay_narrows) {
    // Columns of the grid of each lag, then all pairs of them.
    Eigen::MatrixXd of_lag[2];
    for (std::size_t k = 0; k < 2; ++k) {
      of_lag[k] = Eigen::MatrixXd::Zero(t.size(), k < gains.size() ? decay_grid : 1);
      if (k >= gains.size()) continue;
      const double middle = best(static_cast<Eigen::Index>(k));
      for (Eigen::Index i = 0; i < decay_grid; ++i)
        of_lag[k].col(i) =
            gains[k] * (-t * std::exp(-decay_place(middle, half, i))).array().exp().matrix();
    }
    const Eigen::Vector2d centre = best;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < of_lag[0].cols(); ++i)
      for (Eigen::Index j = 0; j < of_lag[1].cols(); ++j) {
        const double misfit = (u - of_lag[0].col(i) - of_lag[1].col(j)).squaredNorm();
        if (misfit >= least) continue;
        least = misfit;
        best = {decay_place(centre(0), half, i), decay_place(centre(1), half, j)};
      }
  }
  std::vector<double> result;
  for (std::size_t k = 0; k < gains.size(); ++k)
    result.push_back(std::exp(std::clamp(best(static_cast<Eigen::Index>(k)), lower, upper)));
  return result;
}

}  // namespace raceway::spindle
