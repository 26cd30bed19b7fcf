#include "verdict/next_points.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/detail/decompositions.h"

namespace raceway::verdict {

namespace {

constexpr double enough = 20.0;
constexpr int repeats = 2;

/// What one explanation, if true, would leave of another: quadratic forms to which points add.
struct Contest {
  std::size_t truth, wrong;
  Eigen::MatrixXd information{};  // of the wrong one's parameters
  Eigen::VectorXd along{};        // of the difference along them
  double difference = 0.0;        // squared
  Eigen::MatrixXd slope{};        // of the wrong one on the grid, over sigma
  Eigen::VectorXd gap{};          // on the grid, over sigma

  [[nodiscard]] double separation() const {
    return difference - along.dot(algebra::solve_symmetric(information, along));
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

/// The last time of a record, 0 where it has none.
double latest(const record::Record& record) {
  double last = 0.0;
  for (const double t : record.values(record::time)) last = std::fmax(last, t);
  return last;
}

/// Every combination of the levels of the axes as rows of a record: all other settings, and what is
/// a record's own, as in its first row, time at its end, nothing read.
record::Record grid_of(const std::vector<fit::Axis>& axes, const record::Record& record) {
  std::size_t count = 1;
  for (const fit::Axis& axis : axes) count *= axis.levels.size();
  record::Record result = record.without_rows();
  for (record::Column& c : result.columns) {
    double value = unset;
    if (c.channel->is_input() || c.channel->role == record::Role::run ||
        c.channel->role == record::Role::part)
      value = record.value(*c.channel, 0);
    if (c.channel->role == record::Role::time) value = latest(record);
    c.values.assign(count, value);
  }
  std::size_t period = count;
  for (const fit::Axis& axis : axes) {
    period /= axis.levels.size();
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = axis.levels[i / period % axis.levels.size()];
    result.set(*axis.channel, std::move(values));
  }
  return result;
}

/// The choice of points for some rivals.
class Plan {
 public:
  Plan(const Evidence& evidence, const std::vector<const Explanation*>& rivals)
      : evidence_(evidence),
        problem_(evidence.problem),
        rivals_(rivals),
        axes_(problem_.subject->axes(*problem_.record)) {}

  [[nodiscard]] bool possible() const {
    return rivals_.size() >= 2 && !axes_.empty() && !problem_.subject->has_memory();
  }

  NextPoints run(int most) {
    predict_grid();
    make_contests();
    const std::vector<Contest> measured = contests_;
    choose(most);
    exchange(measured);
    NextPoints result{.points = {}, .axes = axes_};
    result.predicted_separation = worst(contests_);
    const double more = static_cast<double>(chosen_.size()) * repeats /
                        static_cast<double>(problem_.observed.size());
    result.separation_by_repetition = (1.0 + more) * worst(measured);
    for (const Eigen::Index p : chosen_) suggest(p, measured, result.points);
    return result;
  }

 private:
  /// Readings of every channel at every point of the grid, of each rival and by its parameters that
  /// are not at a bound, in units of their scale; the same at the rows that were measured.
  void predict_grid() {
    grid_ = std::make_shared<const record::Record>(grid_of(axes_, *problem_.record));
    fit::Observations everywhere{.channels = problem_.observed.channels};
    everywhere.place = problem_.observed.place;
    for (std::size_t c = 0; c < everywhere.channels.size(); ++c) {
      for (std::size_t i = 0; i < grid_->rows(); ++i) everywhere.row.push_back(i);
      everywhere.first.push_back(static_cast<Eigen::Index>(everywhere.row.size()));
    }
    points_ = everywhere.first.back();
    for (const Explanation* rival : rivals_) {
      std::vector<const fit::Screened*> on;
      for (const std::size_t k : rival->members) on.push_back(&problem_.candidates[k]);
      std::vector<Eigen::Index> free;
      for (std::size_t k = 0; k < rival->fit.at_bound.size(); ++k)
        if (!rival->fit.at_bound[k]) free.push_back(static_cast<Eigen::Index>(k));
      const auto slope_of = [&](const fit::Response& response) {
        Eigen::MatrixXd jacobian = response.jacobian(rival->fit.values);
        for (const Eigen::Index k : free)
          jacobian.col(k) *= rival->parameters[static_cast<std::size_t>(k)].scale;
        return Eigen::MatrixXd(jacobian(Eigen::all, free));
      };
      const fit::Response planned = fit::response_with(problem_, on, grid_, everywhere);
      const fit::Response seen = fit::response_with(problem_, on);
      prediction_.push_back(planned.readings(rival->fit.values));
      slope_.push_back(slope_of(planned));
      seen_prediction_.push_back(seen.readings(rival->fit.values));
      seen_slope_.push_back(slope_of(seen));
    }
  }

  /// Standard deviation that readings of these sizes would have.
  [[nodiscard]] Eigen::VectorXd sigma(const Eigen::VectorXd& readings) const {
    Eigen::VectorXd result(points_);
    const auto rows = static_cast<Eigen::Index>(grid_->rows());
    for (std::size_t c = 0; c < evidence_.noise.size(); ++c) {
      const fit::NoiseModel& noise = evidence_.noise[c];
      const Eigen::Index first = static_cast<Eigen::Index>(c) * rows;
      Eigen::ArrayXd growth(rows);
      for (Eigen::Index i = 0; i < rows; ++i)
        growth[i] = noise.growth_at(*grid_, static_cast<std::size_t>(i));
      result.segment(first, rows) =
          (noise.relative * noise.relative * readings.segment(first, rows).array().square() *
               growth.square() +
           noise.absolute * noise.absolute)
              .sqrt()
              .max(1e-6 * noise.rms);
    }
    return result;
  }

  void make_contests() {
    usable_.assign(static_cast<std::size_t>(points_), true);
    for (std::size_t i = 0; i < rivals_.size(); ++i)
      for (std::size_t j = 0; j < rivals_.size(); ++j) {
        if (i == j) continue;
        Contest c{.truth = i, .wrong = j};
        const Eigen::VectorXd sd = sigma(prediction_[i]);
        const Eigen::MatrixXd seen = evidence_.whitening(seen_slope_[j]);
        const Eigen::VectorXd apart =
            evidence_.whitening(Eigen::VectorXd(seen_prediction_[i] - seen_prediction_[j]));
        c.information = seen.transpose() * seen;
        c.information.diagonal().array() *= 1.0 + 1e-10;
        c.along = seen.transpose() * apart;
        c.difference = apart.squaredNorm();
        c.slope = sd.cwiseInverse().asDiagonal() * slope_[j];
        c.gap = (prediction_[i] - prediction_[j]).cwiseQuotient(sd);
        for (Eigen::Index p = 0; p < points_; ++p)
          if (!std::isfinite(c.gap[p]) || !c.slope.row(p).allFinite()) {
            usable_[static_cast<std::size_t>(p)] = false;
            c.gap[p] = 0.0;
            c.slope.row(p).setZero();
          }
        contests_.push_back(std::move(c));
      }
  }

  [[nodiscard]] Eigen::Index best_point(const std::vector<Contest>& state) const {
    double most_apart = -std::numeric_limits<double>::infinity();
    Eigen::Index best = 0;
    for (Eigen::Index p = 0; p < points_; ++p) {
      if (!usable_[static_cast<std::size_t>(p)]) continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Contest& c : state) {
        // Rank one: after the point, s + w (gap - slope·step)² / (1 + w slope A⁻¹ slope).
        const Eigen::VectorXd row = c.slope.row(p).transpose();
        const algebra::SymmetricSolver solver(c.information);
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
  }

  void choose(int most) {
    while (static_cast<int>(chosen_.size()) * repeats < most && worst(contests_) < enough) {
      chosen_.push_back(best_point(contests_));
      for (Contest& c : contests_) c.add(chosen_.back(), repeats);
    }
  }

  /// Each point against the best that the others leave.
  void exchange(const std::vector<Contest>& measured) {
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      std::vector<Contest> state = measured;
      for (std::size_t j = 0; j < chosen_.size(); ++j)
        if (j != k)
          for (Contest& c : state) c.add(chosen_[j], repeats);
      const Eigen::Index other = best_point(state);
      for (Contest& c : state) c.add(other, repeats);
      if (worst(state) <= worst(contests_)) continue;
      chosen_[k] = other;
      contests_ = std::move(state);
    }
  }

  [[nodiscard]] std::string name_of(std::size_t rival) const {
    std::string text;
    for (const std::size_t k : rivals_[rival]->members)
      text += (text.empty() ? "" : " + ") + problem_.candidates[k].id();
    return text;
  }

  void suggest(Eigen::Index p, const std::vector<Contest>& measured,
               std::vector<SuggestedMeasurement>& list) const {
    SuggestedMeasurement m;
    m.repeats = repeats;
    std::vector<fit::Setting> told;
    for (const fit::Axis& axis : axes_) {
      const std::size_t row = static_cast<std::size_t>(p) % grid_->rows();
      m.point.push_back({axis.channel, grid_->value(*axis.channel, row)});
      if (axis.told) told.push_back(m.point.back());
    }
    m.words = problem_.subject->words(told);
    double largest = 0.0;
    for (const Contest& c : measured)
      if (std::abs(c.gap[p]) > largest) {
        largest = std::abs(c.gap[p]);
        m.separates =
            name_of(std::min(c.truth, c.wrong)) + " / " + name_of(std::max(c.truth, c.wrong));
      }
    m.difference_in_sigma = largest;
    const auto same = [&](const SuggestedMeasurement& s) {
      for (std::size_t k = 0; k < m.point.size(); ++k) {
        const double a = s.point[k].value, b = m.point[k].value;
        if (a != b && !(std::isnan(a) && std::isnan(b))) return false;
      }
      return true;
    };
    const auto known = std::find_if(list.begin(), list.end(), same);
    if (known != list.end())
      known->repeats += repeats;
    else
      list.push_back(std::move(m));
  }

  const Evidence& evidence_;
  const fit::Problem& problem_;
  const std::vector<const Explanation*>& rivals_;
  std::vector<fit::Axis> axes_;
  std::shared_ptr<const record::Record> grid_;
  Eigen::Index points_ = 0;  // of the grid, times the channels
  std::vector<Eigen::VectorXd> prediction_, seen_prediction_;
  std::vector<Eigen::MatrixXd> slope_, seen_slope_;
  std::vector<Contest> contests_;
  std::vector<bool> usable_;
  std::vector<Eigen::Index> chosen_;
};

}  // namespace

NextPoints next_points(const Evidence& evidence, const std::vector<const Explanation*>& rivals,
                       int most) {
  Plan plan(evidence, rivals);
  return plan.possible() ? plan.run(most) : NextPoints{};
}

}  // namespace raceway::verdict
