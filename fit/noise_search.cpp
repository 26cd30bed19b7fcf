#include "fit/detail/noise_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algebra/detail/decompositions.h"
#include "fit/distributions.h"
#include "record/repeats.h"

namespace raceway::fit {

namespace {

constexpr double fewest_degrees_of_a_scale = 3.0;
constexpr double worth_a_record = 3.84;     // of -2 ln L: 5 % level of one parameter
constexpr double fewest_of_a_record = 4.0;  // degrees of freedom, to tell its scatter
constexpr double contradicted = 0.01;       // p of declared standard deviations
constexpr Eigen::Index most_rows_of_a_search = 1500;
constexpr int fewest_repeats = 8;

/// Lower triangle of XᵀX.
Eigen::MatrixXd gram_of(const Eigen::MatrixXd& x) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(x.cols(), x.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
  return gram;
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

RestrictedFit::RestrictedFit(const Whitening& whitening, const Eigen::MatrixXd& columns,
                             const Eigen::VectorXd& deviation)
    : x_(whitening(columns)),
      y_(whitening(deviation)),
      root_(gram_of(x_)),
      projected_(x_.transpose() * y_) {
  square_ = y_.squaredNorm() - root_.solve_root(projected_).squaredNorm();
  misfit_ = freedom() * std::log(square_) + whitening.log_determinant() + root_.log_determinant();
}

Eigen::VectorXd RestrictedFit::residual() const { return y_ - x_ * root_.solve(projected_); }

Eigen::VectorXd RestrictedFit::leverage() const {
  return (x_ * root_.inverse().transpose()).rowwise().squaredNorm();
}

NoiseSearch::Regression NoiseSearch::regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  // The columns are independent, so their Gram matrix is regular.
  const Eigen::MatrixXd q = x * algebra::inverse_lower_root(gram_of(x)).transpose();
  Regression result;
  result.fitted = q * (q.transpose() * y);
  result.residual = y - result.fitted;
  result.freedom = (1.0 - q.rowwise().squaredNorm().array()).max(1e-6).matrix();
  return result;
}

Eigen::VectorXd NoiseSearch::shape(const Shares& shares, const Parts& parts,
                                   const Eigen::VectorXd& widening) {
  Eigen::ArrayXd square = shares.relative * parts.reading.array().square() +
                          shares.absolute() * parts.own.array().square();
  if (shares.input > 0.0) square += shares.input * parts.slope.array().square();
  return (square.sqrt() * widening.array()).matrix();
}

Eigen::VectorXd NoiseSearch::of_rms_one(const Eigen::VectorXd& v) {
  const double size = fit::rms(v);
  return size > 0.0 ? Eigen::VectorXd(v / size) : v;
}

NoiseSearch::NoiseSearch(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
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

NoiseModel NoiseSearch::run() {
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
  if (options_.alternatives) find_allowed();
  // Pieces of one dwell tell little more of what states scatter by than one of them.
  if (noise_.state_share > 0.0) {
    const auto states = std::count(order_.new_state.begin(), order_.new_state.end(), true);
    noise_.degrees_of_freedom =
        std::max(fewest_degrees_of_a_scale, static_cast<double>(states - columns_.cols()));
  }
  hold_against_repeats();
  return std::move(noise_);
}

RestrictedFit NoiseSearch::restricted(double phi, double run_share, const Shares& shares) const {
  const Parts some = some_parts();
  const Eigen::VectorXd std = shape(shares, some, stretched()(some_));
  return {Whitening(std, some_order_, phi, run_share, noise_.state_share, common(shares, some),
                    run_unit(std)),
          some_columns_, some_deviation_};
}

NoiseSearch::Parts NoiseSearch::some_parts() const {
  return {parts_.reading(some_), parts_.own(some_),
          parts_.slope.size() > 0 ? Eigen::VectorXd(parts_.slope(some_)) : Eigen::VectorXd()};
}

double NoiseSearch::run_unit(const Eigen::VectorXd& std) const {
  return even_runs_ ? fit::rms(std) : 0.0;
}

Eigen::VectorXd NoiseSearch::common(const Shares& shares, const Parts& parts) const {
  if (readings_.within.size() == 0 || declared_) return {};
  const Eigen::VectorXd all = shape(shares, parts, Eigen::VectorXd::Ones(parts.reading.size()));
  return (std::sqrt(shares.relative) * parts.reading.cwiseAbs()).cwiseQuotient(all);
}

void NoiseSearch::find_records() {
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

Whitening NoiseSearch::scaled(double phi, double run_share, const Shares& shares,
                              double& factor) const {
  const Eigen::VectorXd std = shape(shares, parts_, stretched());
  const Eigen::VectorXd own = common(shares, parts_);
  const Whitening unscaled(std, order_, phi, run_share, noise_.state_share, own, run_unit(std));
  const Regression regression = regress(unscaled(columns_), unscaled(readings_.measured));
  factor = std::sqrt(regression.residual.squaredNorm() / noise_.degrees_of_freedom);
  return unscaled.scaled(factor);
}

void NoiseSearch::set_scale() {
  double factor = 1.0;
  noise_.whitening = scaled(noise_.correlation, noise_.run_share, shares_, factor);
  if (declared_) honour_declared(factor);
  noise_.relative = factor * std::sqrt(shares_.relative) / reading_size_;
  noise_.absolute = factor * std::sqrt(shares_.absolute());
  noise_.input = factor * std::sqrt(shares_.input);
  noise_.run_unit = run_unit(noise_.whitening.std());
  noise_.rms = fit::rms(noise_.whitening.std().cwiseQuotient(widening_));
}

void NoiseSearch::honour_declared(double& factor) {
  const double declared = fit::rms(readings_.std), df = noise_.degrees_of_freedom;
  const double square = std::pow(factor / declared, 2) * df;
  const double p = 2.0 * std::min(chi_squared_below(df, square), chi_squared_above(df, square));
  if (p < contradicted) return;
  factor = declared;
  noise_.as_declared = true;
  noise_.degrees_of_freedom = as_good_as_known;
  const Eigen::VectorXd std = factor * shape(shares_, parts_, stretched());
  noise_.whitening =
      Whitening(std, order_, noise_.correlation, noise_.run_share, 0.0, {}, run_unit(std));
}

void NoiseSearch::find_allowed() {
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
    for (const Shares& s : shares_below(best + within_the_likely)) {
      if (!least || s.relative < least->relative) least = s;
      if (!most || s.relative > most->relative) most = s;
      if (!input || s.input > input->input) input = s;
    }
    for (const auto& s : {least, most})
      if (s && s->relative != shares_.relative) add(phi, g, *s);
    if (input && input->input > shares_.input) add(phi, g, *input);
  }
  if (noise_.growth > 0.0) allow_growths(phi, g, best);
  allow_memory(best);
  if (rival_ && rival_->run_share > 0.0 && noise_.state_share == 0.0) {
    const Memory chosen = memory();
    recall(*rival_);
    add(rival_->correlation, rival_->run_share, shares_);
    allow_memory(best);
    recall(chosen);
  }
  if ((phi > 0.0 || g > 0.0) && allows(0.0, 0.0, shares_)) add(0.0, 0.0, shares_);
}

void NoiseSearch::allow_memory(double best) {
  const double phi = noise_.correlation, g = noise_.run_share;
  double high_phi = phi, high_g = g;
  const double limit = best + within_the_likely;
  if (options_.correlation && order_.has_time)
    for (const double p : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.87, 0.92, 0.95, 0.97})
      if (p > high_phi && misfit(p, g, shares_) < limit) high_phi = p;
  if (options_.runs && order_.has_runs)
    for (double q : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95}) {
      q *= beside_states();
      if (q > high_g && misfit(phi, q, shares_) < limit) high_g = q;
    }
  double factor = 1.0;
  if (high_phi > phi) noise_.allowed.push_back(scaled(high_phi, g, shares_, factor));
  if (high_g > g) noise_.allowed.push_back(scaled(phi, high_g, shares_, factor));
}

void NoiseSearch::hold_against_repeats() {
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

}  // namespace raceway::fit
