#include "fit/noise_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "fit/noise.h"

namespace raceway::fit {

namespace {

constexpr double outlier_limit = 3.5;       // robust standard deviations
constexpr double worth_a_parameter = 2.71;  // of -2 ln L: 5 % level of one variance >= 0
constexpr Eigen::Index most_rows_of_a_search = 1500;
constexpr int fewest_repeats = 8;
constexpr double as_good_as_known = 1000.0;  // degrees of freedom
constexpr double infinity = std::numeric_limits<double>::infinity();

double median(std::vector<double> values) {
  if (values.empty()) return unset;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Least squares with orthogonal columns kept: residual, and how much of each row is left to it.
struct Regression {
  Eigen::VectorXd fitted;    ///< whitened
  Eigen::VectorXd residual;  ///< whitened
  Eigen::VectorXd freedom;   ///< 1 - leverage
  double log_determinant;    ///< of XᵀV⁻¹X
};

Regression regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(x);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(x.rows(), x.cols());
  Regression result;
  result.fitted = q * (q.transpose() * y);
  result.residual = y - result.fitted;
  result.freedom = (1.0 - q.rowwise().squaredNorm().array()).max(1e-6).matrix();
  result.log_determinant = 2.0 * qr.matrixQR().diagonal().head(x.cols()).array().abs().log().sum();
  return result;
}

/// -2 ln of the restricted likelihood, with the common factor of the variance at its best.
/// `deviation`: readings less any fit of the columns, which changes nothing but the rounding.
double restricted(const Whitening& whitening, const Eigen::MatrixXd& columns,
                  const Eigen::VectorXd& deviation) {
  const Eigen::MatrixXd x = whitening(columns);
  const Eigen::VectorXd y = whitening(deviation);
  const auto freedom = static_cast<double>(x.rows() - x.cols());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(x.cols(), x.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
  const Eigen::LLT<Eigen::MatrixXd> root(gram);
  const double fitted = root.matrixL().solve(x.transpose() * y).squaredNorm();
  return freedom * std::log(y.squaredNorm() - fitted) + whitening.log_determinant() +
         2.0 * root.matrixLLT().diagonal().array().log().sum();
}

/// Shape of the standard deviations: share of the relative part in [0, 1].
Eigen::VectorXd shape(double share, const Eigen::VectorXd& torque, const Eigen::VectorXd& own,
                      const Eigen::VectorXd& widening) {
  const double rms = torque.norm() / std::sqrt(static_cast<double>(torque.size()));
  return ((share * (torque / rms).array().square() + (1.0 - share) * own.array().square()).sqrt() *
          widening.array())
      .matrix();
}

/// Rows of contiguous stretches, spread over the data: what a search for variances needs of many.
std::vector<Eigen::Index> stretches(Eigen::Index rows) {
  std::vector<Eigen::Index> chosen;
  if (rows <= most_rows_of_a_search) {
    for (Eigen::Index i = 0; i < rows; ++i) chosen.push_back(i);
    return chosen;
  }
  constexpr Eigen::Index length = 50;
  const Eigen::Index count = most_rows_of_a_search / length;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index first = k * (rows - length) / (count - 1);
    for (Eigen::Index i = first; i < first + length; ++i)
      if (chosen.empty() || i > chosen.back()) chosen.push_back(i);
  }
  return chosen;
}

template <typename T>
T pick(const T& all, const std::vector<Eigen::Index>& rows) {
  return all(rows, Eigen::all);
}

}  // namespace

void sort_rows(DataSet& data) {
  const bool timed = std::all_of(data.rows.begin(), data.rows.end(),
                                 [](const Row& row) { return std::isfinite(row.time); });
  // Runs overlap in time where a run begins before one that began earlier has ended.
  bool overlap = false;
  if (timed) {
    std::map<int, std::pair<double, double>> span;
    for (const Row& row : data.rows) {
      auto [it, fresh] = span.try_emplace(row.run, row.time, row.time);
      it->second.first = std::min(it->second.first, row.time);
      it->second.second = std::max(it->second.second, row.time);
    }
    std::vector<std::pair<double, double>> spans;
    for (const auto& [run, s] : span) spans.push_back(s);
    std::sort(spans.begin(), spans.end());
    for (std::size_t k = 1; k < spans.size(); ++k)
      overlap = overlap || spans[k].first < spans[k - 1].second;
  }
  const auto key = [&](const Row& row) {
    return std::tuple(overlap || !timed ? row.run : 0, timed ? row.time : 0.0, row.point.speed,
                      row.point.axial_load, row.point.radial_load, row.point.temperature,
                      row.measured);
  };
  std::stable_sort(data.rows.begin(), data.rows.end(),
                   [&](const Row& a, const Row& b) { return key(a) < key(b); });
}

RowOrder row_order(const DataSet& data) {
  RowOrder order;
  order.has_time = !data.rows.empty();
  std::vector<double> steps;
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const double before = i == 0 ? unset : data.rows[i - 1].time;
    const double step = data.rows[i].time - before;
    if (!std::isfinite(data.rows[i].time)) order.has_time = false;
    // A step back: the clock of another run.
    order.step.push_back(i == 0 || step < 0.0 || !std::isfinite(step) ? infinity : step);
    order.new_run.push_back(i == 0 || data.rows[i].run != data.rows[i - 1].run);
    if (std::isfinite(order.step.back()) && step > 0.0) steps.push_back(step);
    order.has_runs = order.has_runs || (i > 0 && order.new_run.back());
  }
  if (steps.empty()) order.has_time = false;
  const double middle = order.has_time ? median(steps) : 1.0;
  for (double& step : order.step) step = order.has_time ? std::max(step / middle, 0.05) : infinity;
  return order;
}

NoiseModel known_noise_model(const DataSet& data) {
  Eigen::VectorXd std(static_cast<Eigen::Index>(data.rows.size()));
  for (Eigen::Index i = 0; i < std.size(); ++i) std[i] = data.rows[static_cast<std::size_t>(i)].std;
  NoiseModel noise;
  noise.rms = noise.absolute = std.norm() / std::sqrt(static_cast<double>(std.size()));
  noise.degrees_of_freedom = as_good_as_known;
  noise.whitening = Whitening(std, {}, 0.0, 0.0);
  return noise;
}

NoiseModel estimate_noise_model(const DataSet& data, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& size, const NoiseOptions& options) {
  const auto rows = static_cast<Eigen::Index>(data.rows.size());
  Eigen::VectorXd measured(rows), own = Eigen::VectorXd::Ones(rows);
  bool declared = true;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Row& row = data.rows[static_cast<std::size_t>(i)];
    measured[i] = row.measured;
    declared = declared && std::isfinite(row.std) && row.std > 0.0;
  }
  if (declared) {
    for (Eigen::Index i = 0; i < rows; ++i) own[i] = data.rows[static_cast<std::size_t>(i)].std;
    own *= std::sqrt(static_cast<double>(rows)) / own.norm();
  }
  const RowOrder order = row_order(data);
  const std::vector<Eigen::Index> some = stretches(rows);
  RowOrder some_order = order;
  if (static_cast<Eigen::Index>(some.size()) < rows) {
    some_order.step.clear();
    some_order.new_run.clear();
    for (std::size_t k = 0; k < some.size(); ++k) {
      const auto i = static_cast<std::size_t>(some[k]);
      const bool joined = k > 0 && some[k] == some[k - 1] + 1;
      some_order.step.push_back(joined ? order.step[i] : infinity);
      some_order.new_run.push_back(!joined || order.new_run[i]);
    }
  }
  const Eigen::MatrixXd some_columns = pick(columns, some);
  const Eigen::VectorXd some_measured = measured(some);
  const Eigen::VectorXd some_deviation = regress(some_columns, some_measured).residual;

  NoiseModel noise;
  noise.degrees_of_freedom = static_cast<double>(rows - columns.cols());
  Eigen::VectorXd torque = size, widening = Eigen::VectorXd::Ones(rows);
  double share = 1.0;
  const auto whitening_of = [&](double phi, double g, double relative_share) {
    return Whitening(shape(relative_share, torque(some), own(some), widening(some)), some_order,
                     phi, g);
  };
  // Size of the parts and outliers, first as if rows were independent.
  for (int round = 0; round < 3; ++round) {
    if (options.absolute) {
      double best = infinity;
      for (const double s : {1.0, 0.998, 0.99, 0.97, 0.93, 0.85, 0.7, 0.5, 0.25, 0.1, 0.0}) {
        // The pure forms are preferred unless a mixture is clearly better.
        const double value = restricted(whitening_of(0.0, 0.0, s), some_columns, some_deviation) +
                             (s < 1.0 && s > 0.0 ? 1.0 : 0.0);
        if (value < best) {
          best = value;
          share = s;
        }
      }
    }
    const Whitening independent(shape(share, torque, own, widening), {}, 0.0, 0.0);
    const Regression regression = regress(independent(columns), independent(measured));
    torque = regression.fitted.cwiseProduct(independent.std()).cwiseAbs().cwiseMax(0.1 * size);
    if (!options.outliers) continue;
    // Deviations without the widening of an earlier round.
    Eigen::VectorXd deviation =
        regression.residual.cwiseProduct(widening).cwiseQuotient(regression.freedom.cwiseSqrt());
    std::vector<double> absolute(deviation.data(), deviation.data() + rows);
    for (double& d : absolute) d = std::abs(d);
    const double robust = 1.4826 * median(absolute);
    noise.outliers.clear();
    widening.setOnes();
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double sigmas = std::abs(deviation[i]) / robust;
      if (!(sigmas > outlier_limit) || regression.freedom[i] < 0.1) continue;
      noise.outliers.push_back(static_cast<std::size_t>(i));
      widening[i] = sigmas;
    }
  }
  // Memory: both at once, as each can look like the other.
  double phi = 0.0, g = 0.0;
  const bool timed = options.correlation && order.has_time, runs = options.runs && order.has_runs;
  if (timed || runs) {
    const auto value = [&](double p, double q) {
      return restricted(whitening_of(p, q, share), some_columns, some_deviation) +
             worth_a_parameter * ((p > 0.0 ? 1.0 : 0.0) + (q > 0.0 ? 1.0 : 0.0));
    };
    double best = value(0.0, 0.0);
    for (const double p : {0.0, 0.2, 0.4, 0.6, 0.75, 0.87, 0.95})
      for (const double q : {0.0, 0.1, 0.25, 0.5, 0.75}) {
        if ((p > 0.0 && !timed) || (q > 0.0 && !runs)) continue;
        const double v = value(p, q);
        if (v < best) {
          best = v;
          phi = p;
          g = q;
        }
      }
    for (double step = 0.06; step > 0.005; step *= 0.5)
      for (const auto& [dp, dq] : std::array<std::pair<double, double>, 4>{
               {{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}}) {
        const double p = phi + dp, q = g + dq;
        if ((dp != 0.0 && phi == 0.0) || (dq != 0.0 && g == 0.0)) continue;
        if (p <= 0.0 || p > 0.985 || q <= -1e-12 + (g > 0.0 ? 1e-12 : 0.0) || q > 0.95) continue;
        const double v = value(p, q);
        if (v < best) {
          best = v;
          phi = p;
          g = q;
        }
      }
  }
  noise.correlation = phi;
  noise.run_share = g;
  Eigen::VectorXd std = shape(share, torque, own, widening);
  const Whitening unscaled(std, order, phi, g);
  const Regression regression = regress(unscaled(columns), unscaled(measured));
  const double factor = std::sqrt(regression.residual.squaredNorm() / noise.degrees_of_freedom);
  std *= factor;
  noise.whitening = Whitening(std, order, phi, g);
  const double torque_rms = torque.norm() / std::sqrt(static_cast<double>(rows));
  noise.relative = factor * std::sqrt(share) / torque_rms;
  noise.absolute = factor * std::sqrt(1.0 - share);
  noise.rms = std.cwiseQuotient(widening).norm() / std::sqrt(static_cast<double>(rows));

  // Pure error as a check.
  double square = 0.0;
  int freedom = 0;
  for (const RepeatGroup& group : find_repeats(data)) {
    double weight = 0.0, mean = 0.0;
    for (const std::size_t i : group) {
      const double s = std[static_cast<Eigen::Index>(i)];
      weight += 1.0 / (s * s);
      mean += data.rows[i].measured / (s * s);
    }
    mean /= weight;
    for (const std::size_t i : group) {
      const double d = (data.rows[i].measured - mean) / std[static_cast<Eigen::Index>(i)];
      square += d * d;
    }
    freedom += static_cast<int>(group.size()) - 1;
  }
  if (freedom >= fewest_repeats) {
    noise.repeats_statistic = square / freedom;
    const boost::math::fisher_f f(freedom, noise.degrees_of_freedom);
    const double above = boost::math::cdf(boost::math::complement(f, noise.repeats_statistic));
    noise.repeats_p_value = std::min(1.0, 2.0 * std::min(above, 1.0 - above));
  }
  return noise;
}

}  // namespace raceway::fit
