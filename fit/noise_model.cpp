#include "fit/noise_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "record/repeats.h"

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
Eigen::VectorXd shape(double share, const Eigen::VectorXd& reading, const Eigen::VectorXd& own,
                      const Eigen::VectorXd& widening) {
  const double size = reading.norm() / std::sqrt(static_cast<double>(reading.size()));
  return ((share * (reading / size).array().square() + (1.0 - share) * own.array().square())
              .sqrt() *
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

/// Time since the reading before and whether a run begins, of readings at these rows.
RowOrder row_order(const Record& record, std::span<const std::size_t> rows) {
  RowOrder order;
  order.has_time = !rows.empty();
  std::vector<double> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double now = record.value(record::time, rows[i]);
    const double before = i == 0 ? unset : record.value(record::time, rows[i - 1]);
    const double step = now - before;
    if (!std::isfinite(now)) order.has_time = false;
    // A step back: the clock of another run.
    order.step.push_back(i == 0 || step < 0.0 || !std::isfinite(step) ? infinity : step);
    order.new_run.push_back(i == 0 || record.run_of(rows[i]) != record.run_of(rows[i - 1]));
    if (std::isfinite(order.step.back()) && step > 0.0) steps.push_back(step);
    order.has_runs = order.has_runs || (i > 0 && order.new_run.back());
  }
  if (steps.empty()) order.has_time = false;
  const double middle = order.has_time ? median(steps) : 1.0;
  order.median_step = middle;
  for (double& step : order.step) step = order.has_time ? std::max(step / middle, 0.05) : infinity;
  return order;
}

/// The order of some readings, those that are not neighbours anew.
RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some) {
  if (some.size() == all.step.size()) return all;
  RowOrder order = all;
  order.step.clear();
  order.new_run.clear();
  for (std::size_t k = 0; k < some.size(); ++k) {
    const auto i = static_cast<std::size_t>(some[k]);
    const bool joined = k > 0 && some[k] == some[k - 1] + 1;
    order.step.push_back(joined ? all.step[i] : infinity);
    order.new_run.push_back(!joined || all.new_run[i]);
  }
  return order;
}

/// The search for the noise of one channel, part by part.
class NoiseSearch {
 public:
  NoiseSearch(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
              const Eigen::VectorXd& size, const NoiseOptions& options)
      : readings_(readings),
        columns_(columns),
        size_(size),
        options_(options),
        rows_(readings.measured.size()),
        some_(stretches(rows_)),
        some_order_(order_of(readings.order, some_)),
        some_columns_(pick(columns, some_)),
        some_deviation_(regress(some_columns_, readings.measured(some_)).residual),
        own_(Eigen::VectorXd::Ones(rows_)),
        reading_(size),
        widening_(Eigen::VectorXd::Ones(rows_)) {
    if (readings.std.size() == rows_)
      own_ = readings.std * (std::sqrt(static_cast<double>(rows_)) / readings.std.norm());
  }

  NoiseModel run() {
    noise_.degrees_of_freedom = static_cast<double>(rows_ - columns_.cols());
    noise_.median_step = readings_.order.median_step;
    // Size of the parts and outliers, first as if readings were independent.
    for (int round = 0; round < 3; ++round) {
      if (options_.absolute) find_share();
      find_outliers();
    }
    find_memory();
    set_scale();
    hold_against_repeats();
    return std::move(noise_);
  }

 private:
  [[nodiscard]] double misfit(double phi, double run_share, double relative_share) const {
    return restricted(
        Whitening(shape(relative_share, reading_(some_), own_(some_), widening_(some_)),
                  some_order_, phi, run_share),
        some_columns_, some_deviation_);
  }

  void find_share() {
    double best = infinity;
    for (const double s : {1.0, 0.998, 0.99, 0.97, 0.93, 0.85, 0.7, 0.5, 0.25, 0.1, 0.0}) {
      // The pure forms are preferred unless a mixture is clearly better.
      const double value = misfit(0.0, 0.0, s) + (s < 1.0 && s > 0.0 ? 1.0 : 0.0);
      if (value < best) {
        best = value;
        share_ = s;
      }
    }
  }

  void find_outliers() {
    const Whitening independent(shape(share_, reading_, own_, widening_), {}, 0.0, 0.0);
    const Regression regression = regress(independent(columns_), independent(readings_.measured));
    reading_ = regression.fitted.cwiseProduct(independent.std()).cwiseAbs().cwiseMax(0.1 * size_);
    if (!options_.outliers) return;
    // Deviations without the widening of an earlier round.
    const Eigen::VectorXd deviation =
        regression.residual.cwiseProduct(widening_).cwiseQuotient(regression.freedom.cwiseSqrt());
    std::vector<double> absolute(deviation.data(), deviation.data() + rows_);
    for (double& d : absolute) d = std::abs(d);
    const double robust = 1.4826 * median(absolute);
    noise_.outliers.clear();
    widening_.setOnes();
    for (Eigen::Index i = 0; i < rows_; ++i) {
      const double sigmas = std::abs(deviation[i]) / robust;
      if (!(sigmas > outlier_limit) || regression.freedom[i] < 0.1) continue;
      noise_.outliers.push_back(static_cast<std::size_t>(i));
      widening_[i] = sigmas;
    }
  }

  /// Correlation and runs both at once, as each can look like the other.
  void find_memory() {
    const bool timed = options_.correlation && readings_.order.has_time;
    const bool runs = options_.runs && readings_.order.has_runs;
    if (!timed && !runs) return;
    double &phi = noise_.correlation, &g = noise_.run_share;
    const auto value = [&](double p, double q) {
      return misfit(p, q, share_) +
             worth_a_parameter * ((p > 0.0 ? 1.0 : 0.0) + (q > 0.0 ? 1.0 : 0.0));
    };
    double best = value(0.0, 0.0);
    const auto try_out = [&](double p, double q) {
      const double v = value(p, q);
      if (v >= best) return;
      best = v;
      phi = p;
      g = q;
    };
    for (const double p : {0.0, 0.2, 0.4, 0.6, 0.75, 0.87, 0.95})
      for (const double q : {0.0, 0.1, 0.25, 0.5, 0.75})
        if ((p == 0.0 || timed) && (q == 0.0 || runs)) try_out(p, q);
    for (double step = 0.06; step > 0.005; step *= 0.5)
      for (const auto& [dp, dq] : std::array<std::pair<double, double>, 4>{
               {{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}}) {
        const double p = phi + dp, q = g + dq;
        if ((dp != 0.0 && phi == 0.0) || (dq != 0.0 && g == 0.0)) continue;
        if (p <= 0.0 || p > 0.985 || q <= -1e-12 + (g > 0.0 ? 1e-12 : 0.0) || q > 0.95) continue;
        try_out(p, q);
      }
  }

  void set_scale() {
    Eigen::VectorXd std = shape(share_, reading_, own_, widening_);
    const Whitening unscaled(std, readings_.order, noise_.correlation, noise_.run_share);
    const Regression regression = regress(unscaled(columns_), unscaled(readings_.measured));
    const double factor = std::sqrt(regression.residual.squaredNorm() / noise_.degrees_of_freedom);
    std *= factor;
    noise_.whitening = Whitening(std, readings_.order, noise_.correlation, noise_.run_share);
    noise_.relative = factor * std::sqrt(share_) / fit::rms(reading_);
    noise_.absolute = factor * std::sqrt(1.0 - share_);
    noise_.rms = fit::rms(std.cwiseQuotient(widening_));
  }

  /// Pure error as a check.
  void hold_against_repeats() {
    const Eigen::VectorXd& std = noise_.whitening.std();
    double square = 0.0;
    int freedom = 0;
    for (const record::RepeatGroup& group : readings_.repeats) {
      double weight = 0.0, mean = 0.0;
      for (const std::size_t member : group) {
        const auto i = static_cast<Eigen::Index>(member);
        weight += 1.0 / (std[i] * std[i]);
        mean += readings_.measured[i] / (std[i] * std[i]);
      }
      mean /= weight;
      for (const std::size_t member : group) {
        const auto i = static_cast<Eigen::Index>(member);
        const double d = (readings_.measured[i] - mean) / std[i];
        square += d * d;
      }
      freedom += static_cast<int>(group.size()) - 1;
    }
    if (freedom < fewest_repeats) return;
    noise_.repeats_statistic = square / freedom;
    const boost::math::fisher_f f(freedom, noise_.degrees_of_freedom);
    const double above = boost::math::cdf(boost::math::complement(f, noise_.repeats_statistic));
    noise_.repeats_p_value = std::min(1.0, 2.0 * std::min(above, 1.0 - above));
  }

  const ChannelReadings& readings_;
  const Eigen::MatrixXd& columns_;
  const Eigen::VectorXd& size_;
  const NoiseOptions& options_;
  Eigen::Index rows_;
  std::vector<Eigen::Index> some_;
  RowOrder some_order_;
  Eigen::MatrixXd some_columns_;
  Eigen::VectorXd some_deviation_;
  Eigen::VectorXd own_, reading_, widening_;
  double share_ = 1.0;  // of the relative part
  NoiseModel noise_;
};

/// True where a run begins before one that began earlier has ended.
bool runs_overlap(const Record& record) {
  std::map<int, std::pair<double, double>> span;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    const double t = record.value(record::time, i);
    auto [it, fresh] = span.try_emplace(record.run_of(i), t, t);
    it->second.first = std::min(it->second.first, t);
    it->second.second = std::max(it->second.second, t);
  }
  std::vector<std::pair<double, double>> spans;
  for (const auto& [run, s] : span) spans.push_back(s);
  std::sort(spans.begin(), spans.end());
  for (std::size_t k = 1; k < spans.size(); ++k)
    if (spans[k].first < spans[k - 1].second) return true;
  return false;
}

}  // namespace

std::vector<std::size_t> order_of_rows(const Record& record) {
  const bool timed = record.complete(record::time);
  const bool by_run = record.has(record::run) && (!timed || runs_overlap(record));
  std::vector<std::span<const double>> keys;
  if (by_run) keys.push_back(record.values(record::run));
  if (timed) keys.push_back(record.values(record::time));
  for (const record::Role role : {record::Role::setting, record::Role::measured})
    for (const record::Column& c : record.columns)
      if (c.channel->role == role) keys.emplace_back(c.values);
  std::vector<std::size_t> order(record.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    for (const std::span<const double> key : keys) {
      const double x = std::isnan(key[a]) ? -infinity : key[a];
      const double y = std::isnan(key[b]) ? -infinity : key[b];
      if (x != y) return x < y;
    }
    return false;
  });
  return order;
}

ChannelReadings readings_of(const Record& record, const Observations& observed,
                            std::size_t channel) {
  const std::span<const std::size_t> rows = observed.rows(channel);
  ChannelReadings result{.measured = observed.of(channel, observed.measured)};
  if (const record::Column* const std = record.deviation_of(*observed.channels[channel].channel)) {
    result.std.resize(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.std[static_cast<Eigen::Index>(i)] = std->values[rows[i]];
    if (!result.std.allFinite() || !(result.std.array() > 0.0).all()) result.std.resize(0);
    result.known = std->known && result.std.size() > 0;
  }
  result.order = row_order(record, rows);
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = i;
  for (record::RepeatGroup group : record::find_repeats(record, {}, rows)) {
    for (std::size_t& member : group) member = place.at(member);
    result.repeats.push_back(std::move(group));
  }
  return result;
}

NoiseModel known_noise_model(const ChannelReadings& readings) {
  NoiseModel noise;
  noise.rms = noise.absolute = fit::rms(readings.std);
  noise.degrees_of_freedom = as_good_as_known;
  noise.whitening = Whitening(readings.std, {}, 0.0, 0.0);
  return noise;
}

Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                       const Eigen::VectorXd& size) {
  if (readings.known) return known_noise_model(readings).whitening;
  Eigen::VectorXd own = Eigen::VectorXd::Ones(size.size());
  if (readings.std.size() > 0) own = readings.std / fit::rms(readings.std);
  const Eigen::VectorXd std =
      ((noise.relative * size).array().square() + (noise.absolute * own).array().square()).sqrt();
  // The correlation belongs to the step of the readings that it was found in.
  const double steps = readings.order.median_step / noise.median_step;
  const double correlation = noise.correlation > 0.0 ? std::pow(noise.correlation, steps) : 0.0;
  return {std, readings.order, correlation, noise.run_share};
}

double beyond_noise(double error, double noise) {
  return std::sqrt(std::max(0.0, error * error - noise * noise));
}

void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error) {
  if (!(error > 0.0)) return;
  const Eigen::VectorXd std =
      (noise.whitening.std().array().square() + error * error).sqrt().matrix();
  noise.whitening = Whitening(std, readings.order, noise.correlation, noise.run_share);
  noise.absolute = std::hypot(noise.absolute, error);
  noise.rms = std::hypot(noise.rms, error);
}

NoiseModel estimate_noise_model(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& size, const NoiseOptions& options) {
  return NoiseSearch(readings, columns, size, options).run();
}

}  // namespace raceway::fit
