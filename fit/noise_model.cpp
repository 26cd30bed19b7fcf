#include "fit/noise_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "algebra/detail/decompositions.h"
#include "fit/distributions.h"
#include "fit/dwells.h"
#include "record/levels.h"
#include "record/median.h"
#include "record/repeats.h"

namespace raceway::fit {

namespace {

constexpr double outlier_share = 4.65e-4;   // of a normal law beyond 3.5 standard deviations
constexpr double within_the_likely = 2.71;  // of -2 ln L: 90 % of one parameter
constexpr double unknown_runs = 0.5;        // share of the variance where nothing tells it
constexpr double fewest_degrees_of_a_scale = 3.0;
constexpr double blocks_found = 6.63;  // of -2 ln L: 1 % of one parameter
constexpr int robust_steps = 12;
constexpr double biweight = 4.685;          // robust deviations at which a reading has no weight
constexpr double worth_an_input = 3.84;     // of -2 ln L: 5 % level of one parameter
constexpr double worth_a_record = 3.84;     // the same
constexpr double fewest_of_a_record = 4.0;  // degrees of freedom, to tell its scatter
constexpr double most_outliers = 0.2;       // of the rows
constexpr double undetermined = 0.5;        // of -2 ln L
constexpr double contradicted = 0.01;       // p of declared standard deviations
constexpr double worth_a_parameter = 2.71;  // of -2 ln L: 5 % level of one variance >= 0
constexpr Eigen::Index most_rows_of_a_search = 1500;
constexpr int fewest_repeats = 8;
constexpr double worth_growth = 6.63;     // of -2 ln L: 1 % level of one parameter
constexpr double worth_an_outlier = 6.0;  // the same: one row in twenty
constexpr double may_grow = 1.0;          // standard errors of a first regression
constexpr std::array growths{0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.25, 1.6, 2.0};
constexpr double wide_sweep = 1.5;  // over which growth can be seen
constexpr double gathered = 0.05;   // p of outliers that gather at one level by chance
constexpr std::size_t fewest_gathered = 3, most_levels_of_noise = 24;
constexpr double as_good_as_known = 1000.0;  // degrees of freedom
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Least squares with orthogonal columns kept: residual, and how much of each row is left to it.
struct Regression {
  Eigen::VectorXd fitted;    ///< whitened
  Eigen::VectorXd residual;  ///< whitened
  Eigen::VectorXd freedom;   ///< 1 - leverage
  double log_determinant;    ///< of XᵀV⁻¹X
};

Regression regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  const algebra::HouseholderQr qr(x);
  const Eigen::MatrixXd q = qr.Q();
  Regression result;
  result.fitted = q * (q.transpose() * y);
  result.residual = y - result.fitted;
  result.freedom = (1.0 - q.rowwise().squaredNorm().array()).max(1e-6).matrix();
  result.log_determinant = qr.log_determinant();
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
  const algebra::LowerRoot root(gram);
  const double fitted = root.solve_root(x.transpose() * y).squaredNorm();
  return freedom * std::log(y.squaredNorm() - fitted) + whitening.log_determinant() +
         root.log_determinant();
}

/// Shares of the variance: in proportion to the reading, from the scatter of an input, the rest
/// absolute.
struct Shares {
  double relative = 1.0, input = 0.0;
  [[nodiscard]] double absolute() const { return std::max(0.0, 1.0 - relative - input); }
  [[nodiscard]] int parts() const {
    return (relative > 0.0 ? 1 : 0) + (input > 0.0 ? 1 : 0) + (absolute() > 0.0 ? 1 : 0);
  }
};

/// What the standard deviations are made of, each part with an rms of one.
struct Parts {
  Eigen::VectorXd reading, own, slope;
};

/// Shape of the standard deviations, at some of the readings.
Eigen::VectorXd shape(const Shares& shares, const Parts& parts, const Eigen::VectorXd& widening) {
  Eigen::ArrayXd square = shares.relative * parts.reading.array().square() +
                          shares.absolute() * parts.own.array().square();
  if (shares.input > 0.0) square += shares.input * parts.slope.array().square();
  return (square.sqrt() * widening.array()).matrix();
}

Eigen::VectorXd of_rms_one(const Eigen::VectorXd& v) {
  const double size = fit::rms(v);
  return size > 0.0 ? Eigen::VectorXd(v / size) : v;
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

/// Robust standard deviations beyond which a residual is an outlier: as rare as 3.5 of a known
/// deviation, by Student's law of that many degrees of freedom. A median is as good as a mean over
/// 37 % of them.
double outlier_limit(double degrees_of_freedom) {
  return t_exceeded_with(std::max(2.0, 0.37 * degrees_of_freedom), outlier_share / 2.0);
}

/// Chance of so many hits or more in so many trials.
double binomial_at_least(double hits, double trials, double share) {
  double sum = 0.0;
  for (double k = hits; k <= trials; k += 1.0)
    sum +=
        std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) +
                 k * std::log(share) + (trials - k) * std::log1p(-std::min(share, 1.0 - 1e-12)));
  return sum;
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
        order_(readings.order),
        some_order_(order_of(order_, some_)),
        some_columns_(pick(columns, some_)),
        some_deviation_(regress(some_columns_, readings.measured(some_)).residual),
        declared_(readings.std.size() == rows_),
        widening_(Eigen::VectorXd::Ones(rows_)),
        by_record_(Eigen::VectorXd::Ones(rows_)) {
    parts_.own = declared_                         ? of_rms_one(readings.std)
                 : readings.within.size() == rows_ ? of_rms_one(readings.within)
                                                   : widening_;
    if (readings.swept_by) {
      noise_.swept = readings.swept_by;
      noise_.largest_swept = readings.swept.maxCoeff();
    }
    parts_.reading = of_rms_one(size);
    if (readings.slope.size() == rows_ && readings.slope.norm() > 0.0)
      parts_.slope = of_rms_one(readings.slope);
  }

  NoiseModel run() {
    noise_.degrees_of_freedom = static_cast<double>(rows_ - columns_.cols());
    noise_.median_step = order_.median_step;
    // Size of the parts and outliers, first as if readings were independent.
    if (declared_) shares_ = {.relative = 0.0, .input = 0.0};
    if (options_.absolute && !declared_) find_shares();
    const bool several = !declared_ && !readings_.part.empty();
    if (several) find_records();
    if (options_.outliers) suspect_outliers();
    if (options_.growth && !declared_) find_growth();
    for (int round = 0; round < 3; ++round) {
      if (options_.absolute && !declared_) find_shares();
      find_outliers();
      if (several) find_records();
    }
    // Readings that hardly count tell nothing of the scatter of the others.
    noise_.degrees_of_freedom =
        std::max(fewest_degrees_of_a_scale,
                 noise_.degrees_of_freedom - static_cast<double>(noise_.outliers.size()));
    find_memory();
    if (order_.has_states && options_.runs) find_states();
    if (!order_.has_runs && !order_.new_block.empty()) find_blocks();
    set_scale();
    find_allowed();
    // Pieces of one dwell tell little more of what states scatter by than one of them.
    if (noise_.state_share > 0.0) {
      const auto states = std::count(order_.new_state.begin(), order_.new_state.end(), true);
      noise_.degrees_of_freedom =
          std::max(fewest_degrees_of_a_scale, static_cast<double>(states - columns_.cols()));
    }
    hold_against_repeats();
    return std::move(noise_);
  }

 private:
  [[nodiscard]] double misfit(double phi, double run_share, const Shares& shares) const {
    const Parts some{
        parts_.reading(some_), parts_.own(some_),
        parts_.slope.size() > 0 ? Eigen::VectorXd(parts_.slope(some_)) : Eigen::VectorXd()};
    return restricted(Whitening(shape(shares, some, stretched()(some_)), some_order_, phi,
                                run_share, noise_.state_share, common(shares, some)),
                      some_columns_, some_deviation_);
  }

  /// Share of each standard deviation that neighbours can have in common. Scatter within a dwell
  /// and of an input is excluded; single rows have no excluded part.
  [[nodiscard]] Eigen::VectorXd common(const Shares& shares, const Parts& parts) const {
    if (readings_.within.size() == 0 || declared_) return {};
    const Eigen::VectorXd all = shape(shares, parts, Eigen::VectorXd::Ones(parts.reading.size()));
    return (std::sqrt(shares.relative) * parts.reading.cwiseAbs()).cwiseQuotient(all);
  }

  /// A reading by its size, with the growth of the noise over the swept input.
  [[nodiscard]] Eigen::VectorXd grown(const Eigen::VectorXd& reading) const {
    if (noise_.growth <= 0.0) return reading;
    return reading.array() * (readings_.swept.array() / noise_.largest_swept).pow(noise_.growth);
  }

  /// By what a standard deviation is larger than its parts make it.
  [[nodiscard]] Eigen::VectorXd stretched() const { return widening_.cwiseProduct(by_record_); }

  [[nodiscard]] std::vector<Shares> all_shares() const {
    std::vector<Shares> list;
    for (const double input : {0.0, 0.1, 0.25, 0.45, 0.7, 0.9}) {
      if (input > 0.0 && parts_.slope.size() == 0) break;
      for (const double s : {1.0, 0.998, 0.99, 0.97, 0.93, 0.85, 0.7, 0.5, 0.25, 0.1, 0.0})
        list.push_back({.relative = s * (1.0 - input), .input = input});
    }
    return list;
  }

  double find_shares() { return find_shares(all_shares()); }

  /// The best of these; its -2 ln L with what its parts cost.
  double find_shares(const std::vector<Shares>& list) {
    double best = infinity;
    for (const Shares& s : list) {
      // Fewer parts are preferred unless a mixture is clearly better; of an input that scatters
      // nobody has said anything.
      const double value = misfit(0.0, 0.0, s) + static_cast<double>(s.parts() - 1) +
                           (s.input > 0.0 ? worth_an_input : 0.0);
      if (value < best) {
        best = value;
        shares_ = s;
      }
    }
    return best;
  }

  /// Whether the relative part grows with the input that is swept, and how. Under each growth the
  /// doubtful readings are others: each of them costs what its rarity is worth.
  void find_growth() {
    if (!readings_.swept_by || !seems_to_grow()) return;
    const auto doubts = [this] {
      return worth_an_outlier * static_cast<double>((widening_.array() > 1.0).count());
    };
    const Shares shares = shares_;
    const Eigen::VectorXd widening = widening_;
    std::vector<Shares> few{{1.0, 0.0}, {0.97, 0.0}, {0.85, 0.0}, {0.5, 0.0}};
    if (parts_.slope.size() > 0) few.insert(few.end(), {{0.9, 0.1}, {0.7, 0.25}, {0.5, 0.45}});
    double best = find_shares() + doubts() - worth_growth, growth = 0.0;
    for (const double p : growths) {
      noise_.growth = p;
      parts_.reading = of_rms_one(grown(size_));
      widening_.setOnes();
      find_shares(few);
      if (options_.outliers) suspect_outliers();
      const double value = find_shares(few) + doubts();
      if (!(value < best)) continue;
      best = value;
      growth = p;
    }
    noise_.growth = growth;
    parts_.reading = of_rms_one(grown(size_));
    if (growth > 0.0) {
      widening_.setOnes();
      find_shares(few);
      if (options_.outliers) suspect_outliers();
      find_shares();
    } else {
      shares_ = shares;
      widening_ = widening;
    }
  }

  /// A first look: logarithms of what the saturated regression leaves against the logarithm of the
  /// swept input. ln |z| of a normal law has a standard deviation of 1.11.
  [[nodiscard]] bool seems_to_grow() const {
    const Whitening independent(shape(shares_, parts_, by_record_), {}, 0.0, 0.0);
    const Regression r = regress(independent(columns_), independent(readings_.measured));
    const Eigen::ArrayXd x = readings_.swept.array().log();
    const Eigen::ArrayXd y = (r.residual.array().abs() / r.freedom.array().sqrt()).max(1e-12).log();
    const Eigen::ArrayXd w = r.freedom.array();
    const double mean_x = (w * x).sum() / w.sum(), mean_y = (w * y).sum() / w.sum();
    const double spread = (w * (x - mean_x).square()).sum();
    if (!(spread > 0.0)) return false;
    const double power = (w * (x - mean_x) * (y - mean_y)).sum() / spread;
    return power * std::sqrt(spread) > 1.11 * may_grow;
  }

  /// Readings that gather at one level of a setting are no outliers: there the rig scatters more.
  void spare_levels() {
    std::vector<bool> far(static_cast<std::size_t>(rows_));
    double all = 0.0;
    for (Eigen::Index i = 0; i < rows_; ++i) {
      far[static_cast<std::size_t>(i)] = widening_[i] > 1.0;
      all += widening_[i] > 1.0 ? 1.0 : 0.0;
    }
    for (const std::vector<std::size_t>& level : readings_.levels) {
      const std::size_t count = 1 + *std::max_element(level.begin(), level.end());
      for (std::size_t k = 0; k < count; ++k) {
        double rows = 0.0, here = 0.0;
        for (std::size_t i = 0; i < level.size(); ++i)
          if (level[i] == k) {
            rows += 1.0;
            here += far[i] ? 1.0 : 0.0;
          }
        if (here < static_cast<double>(fewest_gathered) ||
            binomial_at_least(here, all, rows / static_cast<double>(rows_)) *
                    static_cast<double>(count) >
                gathered)
          continue;
        for (std::size_t i = 0; i < level.size(); ++i)
          if (level[i] == k) widening_[static_cast<Eigen::Index>(i)] = 1.0;
      }
    }
  }

  /// First doubts, from a regression of few columns that outliers cannot bend to themselves, as
  /// they do with one that has half as many columns as rows: reweighted by Tukey's biweight from
  /// least absolute deviations. What is doubted without reason find_outliers() takes back.
  void suspect_outliers() {
    const Eigen::Index some = std::min(columns_.cols(), rows_ / 6);
    const Eigen::VectorXd scale = shape(shares_, parts_, stretched()).cwiseInverse();
    const Eigen::MatrixXd x = scale.asDiagonal() * columns_.leftCols(some);
    const Eigen::VectorXd y = scale.cwiseProduct(readings_.measured);
    Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(rows_), deviation;
    double robust = 0.0;
    for (int k = 0; k < robust_steps; ++k) {
      const Eigen::VectorXd root = weight.sqrt().matrix();
      const Regression r = regress(root.asDiagonal() * x, root.cwiseProduct(y));
      deviation = (r.residual.cwiseQuotient(root).array() / r.freedom.array().sqrt()).abs();
      robust = 1.4826 * record::median({deviation.begin(), deviation.end()});
      if (!(robust > 0.0)) return;
      const Eigen::ArrayXd far = deviation / robust;
      if (k < robust_steps / 2)
        weight = far.cwiseMax(1.0).inverse();
      else
        weight = (1.0 - (far / biweight).square()).cwiseMax(0.03).square();
    }
    const double limit = outlier_limit(static_cast<double>(rows_ - some));
    for (Eigen::Index i = 0; i < rows_; ++i)
      if (const double far = deviation[i] / robust; far > limit) widening_[i] = far * far / limit;
    // So many are no outliers, but what so few columns cannot follow.
    if (static_cast<double>((widening_.array() > 1.0).count()) >
        most_outliers * static_cast<double>(rows_))
      widening_.setOnes();
    spare_levels();
  }

  void find_outliers() {
    const Whitening independent(shape(shares_, parts_, stretched()), {}, 0.0, 0.0);
    const Regression regression = regress(independent(columns_), independent(readings_.measured));
    const Eigen::VectorXd reading =
        regression.fitted.cwiseProduct(independent.std()).cwiseAbs().cwiseMax(0.1 * size_);
    const Eigen::VectorXd by_swept = grown(reading);
    reading_size_ = fit::rms(by_swept);
    parts_.reading = of_rms_one(by_swept);
    if (!options_.outliers) return;
    // Deviations without the widening of an earlier round.
    const Eigen::VectorXd deviation =
        regression.residual.cwiseProduct(widening_).cwiseQuotient(regression.freedom.cwiseSqrt());
    std::vector<double> absolute(deviation.data(), deviation.data() + rows_);
    for (double& d : absolute) d = std::abs(d);
    const double robust = 1.4826 * record::median(absolute);
    const double limit = outlier_limit(noise_.degrees_of_freedom);
    noise_.outliers.clear();
    widening_.setOnes();
    for (Eigen::Index i = 0; i < rows_; ++i) {
      const double sigmas = std::abs(deviation[i]) / robust;
      if (!(sigmas > limit) || regression.freedom[i] < 0.1) continue;
      // What is far off says little: its pull falls as it moves further.
      widening_[i] = sigmas * sigmas / limit;
    }
    spare_levels();
    for (Eigen::Index i = 0; i < rows_; ++i)
      if (widening_[i] > 1.0) noise_.outliers.push_back(static_cast<std::size_t>(i));
  }

  /// How much each of several records scatters, of the common shape: days and sensors differ.
  void find_records() {
    const std::size_t count = 1 + *std::max_element(readings_.part.begin(), readings_.part.end());
    const Eigen::VectorXd before = by_record_;
    by_record_.setOnes();
    const double alike = misfit(0.0, 0.0, shares_);
    by_record_ = before;
    const Whitening independent(shape(shares_, parts_, stretched()), {}, 0.0, 0.0);
    const Regression r = regress(independent(columns_), independent(readings_.measured));
    std::vector<double> square(count, 0.0), freedom(count, 0.0), factor(count, 1.0);
    for (Eigen::Index i = 0; i < rows_; ++i) {
      const std::size_t k = readings_.part[static_cast<std::size_t>(i)];
      square[k] += std::pow(r.residual[i] * before[i], 2);
      freedom[k] += r.freedom[i];
    }
    double parameters = -1.0;  // the size of all is no parameter of the shape
    for (std::size_t k = 0; k < count; ++k)
      if (freedom[k] >= fewest_of_a_record && square[k] > 0.0) {
        factor[k] = std::sqrt(square[k] / freedom[k]);
        parameters += 1.0;
      }
    double all = 0.0;
    for (std::size_t k = 0; k < count; ++k) all += freedom[k] * std::log(factor[k]);
    all = std::exp(all / static_cast<double>(r.freedom.sum()));
    for (Eigen::Index i = 0; i < rows_; ++i)
      by_record_[i] = factor[readings_.part[static_cast<std::size_t>(i)]] / all;
    noise_.records.clear();
    if (misfit(0.0, 0.0, shares_) + worth_a_record * parameters < alike)
      for (std::size_t k = 0; k < count; ++k) noise_.records.push_back(factor[k] / all);
    else
      by_record_.setOnes();
  }

  /// Correlation and runs both at once, as each can look like the other.
  void find_memory() {
    const bool timed = options_.correlation && order_.has_time;
    const bool runs = options_.runs && order_.has_runs;
    if (!timed && !runs) return;
    double &phi = noise_.correlation, &g = noise_.run_share;
    const auto value = [&](double p, double q) {
      return misfit(p, q, shares_) +
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
    // Where runs and levels coincide nothing says how much the runs differ: as much as may be.
    if (runs && misfit(phi, unknown_runs, shares_) < misfit(phi, g, shares_) + undetermined) {
      g = std::max(g, unknown_runs);
      noise_.unknown_runs = true;
    }
  }

  /// Finds the offset that the pieces of one dwell have in common. It competes with the correlation
  /// between neighbours, so both are searched together.
  void find_states() {
    const double phi = noise_.correlation, g = noise_.run_share;
    double best = misfit(phi, g, shares_) + worth_a_parameter * (phi > 0.0 ? 1.0 : 0.0);
    NoiseModel chosen = noise_;
    for (const double h : {0.1, 0.25, 0.5, 0.75, 0.9})
      for (const double p : {0.0, phi}) {
        if (g + h > 0.98) continue;
        noise_.state_share = h;
        const double value =
            misfit(p, g, shares_) + worth_a_parameter * (1.0 + (p > 0.0 ? 1.0 : 0.0));
        if (!(value < best)) continue;
        best = value;
        chosen.correlation = p;
        chosen.state_share = h;
      }
    noise_ = std::move(chosen);
  }

  /// Offsets that follow blocks of rows which nobody declared as runs.
  void find_blocks() {
    const double before = misfit(noise_.correlation, 0.0, shares_);
    const NoiseModel without = noise_;
    const RowOrder order = order_, some = some_order_;
    for (RowOrder* of : {&order_, &some_order_}) {
      of->new_run = of->new_block;
      of->has_runs = true;
    }
    noise_.correlation = 0.0;
    find_memory();
    if (misfit(noise_.correlation, noise_.run_share, shares_) < before - blocks_found) {
      noise_.undeclared_blocks = true;
      return;
    }
    noise_ = without;
    order_ = order;
    some_order_ = some;
  }

  /// Scaled to what the regression leaves.
  [[nodiscard]] Whitening scaled(double phi, double run_share, const Shares& shares,
                                 double& factor) const {
    const Eigen::VectorXd std = shape(shares, parts_, stretched());
    const Eigen::VectorXd own = common(shares, parts_);
    const Whitening unscaled(std, order_, phi, run_share, noise_.state_share, own);
    const Regression regression = regress(unscaled(columns_), unscaled(readings_.measured));
    factor = std::sqrt(regression.residual.squaredNorm() / noise_.degrees_of_freedom);
    return {Eigen::VectorXd(factor * std), order_, phi, run_share, noise_.state_share, own};
  }

  void set_scale() {
    double factor = 1.0;
    noise_.whitening = scaled(noise_.correlation, noise_.run_share, shares_, factor);
    if (declared_) honour_declared(factor);
    noise_.relative = factor * std::sqrt(shares_.relative) / reading_size_;
    noise_.absolute = factor * std::sqrt(shares_.absolute());
    noise_.input = factor * std::sqrt(shares_.input);
    noise_.rms = fit::rms(noise_.whitening.std().cwiseQuotient(widening_));
  }

  /// Declared standard deviations that the readings do not contradict are taken as they are.
  void honour_declared(double& factor) {
    const double declared = fit::rms(readings_.std), df = noise_.degrees_of_freedom;
    const double square = std::pow(factor / declared, 2) * df;
    const double p = 2.0 * std::min(chi_squared_below(df, square), chi_squared_above(df, square));
    if (p < contradicted) return;
    factor = declared;
    noise_.as_declared = true;
    noise_.degrees_of_freedom = as_good_as_known;
    noise_.whitening = Whitening(factor * shape(shares_, parts_, stretched()), order_,
                                 noise_.correlation, noise_.run_share);
  }

  /// Shapes whose likelihood is within reach of the best: each part of the noise to both ends of
  /// what the readings allow, and no memory where they allow that.
  void find_allowed() {
    const double phi = noise_.correlation, g = noise_.run_share;
    const double best = misfit(phi, g, shares_);
    const auto allows = [&](double p, double q, const Shares& s) {
      return misfit(p, q, s) < best + within_the_likely;
    };
    const auto add = [&](double p, double q, const Shares& s) {
      double factor = 1.0;
      noise_.allowed.push_back(scaled(p, q, s, factor));
    };
    if (options_.absolute && !declared_) {
      std::optional<Shares> least, most, input;
      for (const Shares& s : all_shares()) {
        if (!allows(phi, g, s)) continue;
        if (!least || s.relative < least->relative) least = s;
        if (!most || s.relative > most->relative) most = s;
        if (!input || s.input > input->input) input = s;
      }
      for (const auto& s : {least, most})
        if (s && s->relative != shares_.relative) add(phi, g, *s);
      if (input && input->input > shares_.input) add(phi, g, *input);
    }
    if (noise_.growth > 0.0) allow_growths(phi, g, best);
    const bool timed = options_.correlation && order_.has_time;
    const bool runs = options_.runs && order_.has_runs;
    double high_phi = phi, high_g = g;
    if (timed)
      for (const double p : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.87, 0.92, 0.95, 0.97})
        if (p > high_phi && allows(p, g, shares_)) high_phi = p;
    if (runs)
      for (const double q : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95})
        if (q > high_g && allows(phi, q, shares_)) high_g = q;
    if (high_phi > phi) add(high_phi, g, shares_);
    if (high_g > g) add(phi, high_g, shares_);
    if ((phi > 0.0 || g > 0.0) && allows(0.0, 0.0, shares_)) add(0.0, 0.0, shares_);
  }

  /// Less growth and more, as far as the readings allow.
  void allow_growths(double phi, double g, double best) {
    const double growth = noise_.growth;
    const Eigen::VectorXd reading = parts_.reading;
    const auto set = [&](double p) {
      parts_.reading = of_rms_one(Eigen::VectorXd(
          reading.array() * (readings_.swept.array() / noise_.largest_swept).pow(p - growth)));
    };
    double least = growth, most = growth;
    for (const double p : growths) {
      set(p);
      if (!(misfit(phi, g, shares_) < best + within_the_likely)) continue;
      least = std::min(least, p);
      most = std::max(most, p);
    }
    for (const double p : {least, most}) {
      if (p == growth) continue;
      set(p);
      double factor = 1.0;
      noise_.allowed.push_back(scaled(phi, g, shares_, factor));
    }
    parts_.reading = reading;
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
    const double above = f_above(freedom, noise_.degrees_of_freedom, noise_.repeats_statistic);
    noise_.repeats_p_value = std::min(1.0, 2.0 * std::min(above, 1.0 - above));
  }

  const ChannelReadings& readings_;
  const Eigen::MatrixXd& columns_;
  const Eigen::VectorXd& size_;
  const NoiseOptions& options_;
  Eigen::Index rows_;
  std::vector<Eigen::Index> some_;
  RowOrder order_, some_order_;
  Eigen::MatrixXd some_columns_;
  Eigen::VectorXd some_deviation_;
  bool declared_;
  Parts parts_;
  double reading_size_ = unset;  // rms of what Parts::reading has without its scale [SI]
  Eigen::VectorXd widening_;     // of outliers
  Eigen::VectorXd by_record_;    // NoiseModel::records
  Shares shares_;
  NoiseModel noise_;
};

/// The values of a column at these rows, where all are above zero and the largest is by a factor
/// above the smallest; otherwise none.
Eigen::VectorXd positive(std::span<const double> column, std::span<const std::size_t> rows,
                         double factor) {
  if (column.empty() || rows.empty()) return {};
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = column[rows[i]];
  const bool all = values.allFinite() && (values.array() > 0.0).all();
  return all && values.maxCoeff() > factor * values.minCoeff() ? values : Eigen::VectorXd();
}

/// The level of each reading on a setting, where it stands at some few.
void add_levels(const record::Column& column, std::span<const std::size_t> rows,
                std::vector<std::vector<std::size_t>>& levels) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(column.values[row]);
  const std::vector<double> starts =
      record::level_starts(values, record::step_of(*column.channel, values));
  if (starts.size() < 2 || starts.size() > most_levels_of_noise) return;
  std::vector<std::size_t>& own = levels.emplace_back();
  for (const double value : values) own.push_back(record::level_of(value, starts));
}

}  // namespace

void NoiseModel::scale(double factor) {
  for (double* const size : {&relative, &absolute, &input, &rms}) *size *= factor;
  whitening = whitening.scaled(factor);
  for (Whitening& other : allowed) other = other.scaled(factor);
}

double NoiseModel::growth_at(const Record& record, std::size_t row) const {
  return growth > 0.0 ? std::pow(record.value(*swept, row) / largest_swept, growth) : 1.0;
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
  result.within = positive(record.values(dwell_scatter), rows, 0.0);
  for (const record::Column& column : record.columns) {
    if (column.channel->role != record::Role::setting || !column.channel->ratio) continue;
    add_levels(column, rows, result.levels);
    if (result.swept_by) continue;
    result.swept = positive(column.values, rows, wide_sweep);
    if (result.swept.size() > 0) result.swept_by = column.channel;
  }
  result.order = row_order(record, rows);
  if (!record.parts.empty())
    for (const std::size_t row : rows) result.part.push_back(record.part_of(row));
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
  if (readings.std.size() > 0)
    own = readings.std / fit::rms(readings.std);
  else if (readings.within.size() > 0)
    own = readings.within / fit::rms(readings.within);
  Eigen::VectorXd relative = noise.relative * size;
  if (noise.growth > 0.0)
    relative.array() *= (readings.swept.array() / noise.largest_swept).pow(noise.growth);
  Eigen::VectorXd std =
      (relative.array().square() + (noise.absolute * own).array().square()).sqrt();
  if (!noise.records.empty())
    for (Eigen::Index i = 0; i < std.size(); ++i)
      std[i] *= noise.records.at(readings.part.at(static_cast<std::size_t>(i)));
  // The correlation belongs to the step of the readings that it was found in.
  const double steps = readings.order.median_step / noise.median_step;
  const double correlation = noise.correlation > 0.0 ? std::pow(noise.correlation, steps) : 0.0;
  return {std, readings.order, correlation, noise.run_share, noise.state_share};
}

double beyond_noise(double error, double noise) {
  return std::sqrt(std::max(0.0, error * error - noise * noise));
}

void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error) {
  if (!(error > 0.0)) return;
  const Eigen::VectorXd std =
      (noise.whitening.std().array().square() + error * error).sqrt().matrix();
  noise.whitening =
      Whitening(std, readings.order, noise.correlation, noise.run_share, noise.state_share);
  noise.absolute = std::hypot(noise.absolute, error);
  noise.rms = std::hypot(noise.rms, error);
}

NoiseModel estimate_noise_model(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& size, const NoiseOptions& options) {
  return NoiseSearch(readings, columns, size, options).run();
}

}  // namespace raceway::fit
