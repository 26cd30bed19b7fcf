#include "fit/next_points.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace raceway::fit {

namespace {

constexpr double enough = 20.0;
constexpr int repeats = 2;

/// Levels within the range of the data: the extremes and between, in ratio where that is wide.
std::vector<double> grid(double low, double high, int count) {
  if (!(high - low > 1e-3 * std::abs(high))) return {0.5 * (low + high)};
  std::vector<double> levels;
  const bool ratio = low > 0.0 && high > 3.0 * low;
  for (int k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / (count - 1);
    levels.push_back(ratio ? low * std::pow(high / low, part) : low + part * (high - low));
  }
  return levels;
}

/// Preloads of the sets that may be tried: those of the data, or the one there is and others that a
/// spindle of that preload stands. NaN, "as it is", for a bearing on a rig.
std::vector<double> preload_levels(const Problem& problem, double low, double high) {
  if (problem.data.quantity != Quantity::axial_displacement) return {unset};
  if (high > 1.05 * low) return grid(low, high, 3);
  const double one = std::isfinite(low) ? low : problem.model.shaft->arrangement.preload();
  if (!(one > 0.0)) return {unset};
  return {std::isfinite(low) ? one : unset, 0.5 * one, 2.0 * one};
}

/// What one explanation, if true, would leave of another: quadratic forms to which points add.
struct Contest {
  std::size_t truth, wrong;
  Eigen::MatrixXd information{};  // of the wrong one's parameters
  Eigen::VectorXd along{};        // of the difference along them
  double difference = 0.0;        // squared
  Eigen::MatrixXd slope{};        // of the wrong one on the grid, over sigma
  Eigen::VectorXd gap{};          // on the grid, over sigma

  [[nodiscard]] double separation() const {
    return difference - along.dot(information.ldlt().solve(along));
  }
  void add(Eigen::Index point, double weight) {
    information += weight * slope.row(point).transpose() * slope.row(point);
    along += weight * gap[point] * slope.row(point).transpose();
    difference += weight * gap[point] * gap[point];
  }
};

double worst(const std::vector<Contest>& contests) {
  double least = std::numeric_limits<double>::infinity();
  for (const Contest& c : contests) least = std::min(least, c.separation());
  return least;
}

}  // namespace

NextPoints next_points(const Problem& problem, const NoiseModel& noise,
                       const std::vector<const Explanation*>& rivals, int most) {
  NextPoints result;
  if (rivals.size() < 2) return result;
  Problem planned = problem;  // its rows: the grid, then the rows measured
  Row mean = problem.data.rows.front();
  mean.std = unset;
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void take(double v) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  } speed, axial, radial, temperature, preload;
  double time = 0.0;
  for (const Row& row : problem.data.rows) {
    speed.take(row.point.speed);
    axial.take(row.point.axial_load);
    radial.take(row.point.radial_load);
    temperature.take(row.point.temperature);
    preload.take(row.preload);  // NaN changes nothing
    if (std::isfinite(row.time)) time = std::max(time, row.time);
  }
  mean.time = time;
  planned.data.rows.clear();
  planned.balances.clear();
  const std::vector<double> preloads = preload_levels(problem, preload.low, preload.high);
  for (const double n : grid(speed.low, speed.high, 7))
    for (const double f : grid(axial.low, axial.high, 5))
      for (const double r : grid(radial.low, radial.high, 3))
        for (const double t : grid(temperature.low, temperature.high, 4))
          for (const double p : preloads) {
            Row row = mean;
            row.point.speed = n;
            row.point.axial_load = f;
            row.point.radial_load = r;
            row.point.temperature = t;
            row.preload = p;
            planned.data.rows.push_back(row);
          }
  const auto points = static_cast<Eigen::Index>(planned.data.rows.size());
  for (const Row& row : problem.data.rows) planned.data.rows.push_back(row);
  const Eigen::Index old = problem.measured.size();

  std::vector<Eigen::VectorXd> prediction;
  std::vector<Eigen::MatrixXd> slope;
  for (const Explanation* rival : rivals) {
    std::vector<const Candidate*> on;
    for (const std::size_t k : rival->members) on.push_back(&problem.candidates[k]);
    const Response response = response_with(planned, on);
    prediction.push_back(response.readings(rival->fit.values));
    Eigen::MatrixXd jacobian = response.jacobian(rival->fit.values);
    std::vector<Eigen::Index> free;
    for (std::size_t k = 0; k < rival->fit.at_bound.size(); ++k) {
      if (rival->fit.at_bound[k]) continue;
      free.push_back(static_cast<Eigen::Index>(k));
      jacobian.col(static_cast<Eigen::Index>(k)) *= rival->parameters[k].scale;
    }
    slope.push_back(jacobian(Eigen::all, free));
  }
  std::vector<Contest> contests;
  std::vector<bool> usable(static_cast<std::size_t>(points), true);
  for (std::size_t i = 0; i < rivals.size(); ++i)
    for (std::size_t j = 0; j < rivals.size(); ++j) {
      if (i == j) continue;
      Contest c{.truth = i, .wrong = j};
      const Eigen::VectorXd gap = prediction[i] - prediction[j];
      const Eigen::VectorXd sigma =
          (noise.relative * noise.relative * prediction[i].head(points).array().square() +
           noise.absolute * noise.absolute)
              .sqrt()
              .max(1e-6 * noise.rms);
      const Eigen::MatrixXd seen = noise.whitening(Eigen::MatrixXd(slope[j].bottomRows(old)));
      const Eigen::VectorXd apart = noise.whitening(Eigen::VectorXd(gap.tail(old)));
      c.information = seen.transpose() * seen;
      c.information.diagonal().array() *= 1.0 + 1e-10;
      c.along = seen.transpose() * apart;
      c.difference = apart.squaredNorm();
      c.slope = sigma.cwiseInverse().asDiagonal() * slope[j].topRows(points);
      c.gap = gap.head(points).cwiseQuotient(sigma);
      for (Eigen::Index p = 0; p < points; ++p)
        if (!std::isfinite(c.gap[p]) || !c.slope.row(p).allFinite()) {
          usable[static_cast<std::size_t>(p)] = false;
          c.gap[p] = 0.0;
          c.slope.row(p).setZero();
        }
      contests.push_back(std::move(c));
    }
  const auto best_point = [&](const std::vector<Contest>& state) {
    double most_apart = -std::numeric_limits<double>::infinity();
    Eigen::Index best = 0;
    for (Eigen::Index p = 0; p < points; ++p) {
      if (!usable[static_cast<std::size_t>(p)]) continue;
      std::vector<Contest> trial;
      double least = std::numeric_limits<double>::infinity();
      for (const Contest& c : state) {
        // Rank one: after the point, s + w (gap - slope·step)² / (1 + w slope A⁻¹ slope).
        const Eigen::VectorXd row = c.slope.row(p).transpose();
        const auto solver = c.information.ldlt();
        const double miss = c.gap[p] - row.dot(solver.solve(c.along));
        const double spread = 1.0 + repeats * row.dot(solver.solve(row));
        least = std::min(least, c.separation() + repeats * miss * miss / spread);
      }
      if (least > most_apart) {
        most_apart = least;
        best = p;
      }
    }
    return best;
  };
  const std::vector<Contest> measured = contests;
  std::vector<Eigen::Index> chosen;
  while (static_cast<int>(chosen.size()) * repeats < most && worst(contests) < enough) {
    chosen.push_back(best_point(contests));
    for (Contest& c : contests) c.add(chosen.back(), repeats);
  }
  // Exchange: each point against the best that the others leave.
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    std::vector<Contest> state = measured;
    for (std::size_t j = 0; j < chosen.size(); ++j)
      if (j != k)
        for (Contest& c : state) c.add(chosen[j], repeats);
    const Eigen::Index other = best_point(state);
    for (Contest& c : state) c.add(other, repeats);
    if (worst(state) > worst(contests)) {
      chosen[k] = other;
      contests = std::move(state);
    }
  }
  result.predicted_separation = worst(contests);
  const double more = static_cast<double>(chosen.size()) * repeats / static_cast<double>(old);
  result.separation_by_repetition = (1.0 + more) * worst(measured);
  const auto name_of = [&](std::size_t rival) {
    std::string text;
    for (const std::size_t k : rivals[rival]->members)
      text += (text.empty() ? "" : " + ") + problem.candidates[k].id;
    return text;
  };
  for (const Eigen::Index p : chosen) {
    const Row& row = planned.data.rows[static_cast<std::size_t>(p)];
    SuggestedMeasurement m{.point = row.point, .preload = row.preload, .repeats = repeats};
    double largest = 0.0;
    for (const Contest& c : measured)
      if (std::abs(c.gap[p]) > largest) {
        largest = std::abs(c.gap[p]);
        m.separates =
            name_of(std::min(c.truth, c.wrong)) + " / " + name_of(std::max(c.truth, c.wrong));
      }
    m.difference_in_sigma = largest;
    const auto same = [&](const SuggestedMeasurement& s) {
      return s.point.speed == m.point.speed && s.point.axial_load == m.point.axial_load &&
             s.point.radial_load == m.point.radial_load &&
             s.point.temperature == m.point.temperature &&
             (s.preload == m.preload || (std::isnan(s.preload) && std::isnan(m.preload)));
    };
    const auto known = std::find_if(result.points.begin(), result.points.end(), same);
    if (known != result.points.end())
      known->repeats += repeats;
    else
      result.points.push_back(std::move(m));
  }
  return result;
}

std::vector<std::string> records_needed(const Problem& problem,
                                        const std::vector<const Explanation*>& rivals) {
  if (problem.data.quantity != Quantity::axial_displacement) return {};
  const auto warm = [&](std::size_t k) { return problem.candidates[k].description->follows_heat; };
  const auto by_heat = [&](const Explanation* e) {
    return std::any_of(e->members.begin(), e->members.end(), warm);
  };
  const bool untested = std::any_of(
      problem.candidates.begin(), problem.candidates.end(),
      [](const Candidate& c) { return c.description->follows_heat && !c.not_testable.empty(); });
  if ((!untested && std::none_of(rivals.begin(), rivals.end(), by_heat)) ||
      std::all_of(rivals.begin(), rivals.end(), by_heat))
    return {};
  std::vector<std::string> list;
  const auto rings = [](const Row& r) {
    return std::isfinite(r.inner_ring_temperature) && std::isfinite(r.outer_ring_temperature);
  };
  if (!std::all_of(problem.data.rows.begin(), problem.data.rows.end(), rings))
    list.emplace_back(
        "ring temperatures (inner_ring_temperature_C, outer_ring_temperature_C), which say what "
        "expands");
  list.emplace_back(
      "the same speeds up and down, each soon after a change and again when warm: heat lags "
      "behind, speed does not");
  return list;
}

}  // namespace raceway::fit
