#include "rig/sensor_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "fit/distributions.h"
#include "record/levels.h"
#include "rig/detail/curve_fit.h"

namespace raceway::rig {
namespace {

constexpr double surely = 1e-4;           // chance below which another degree than asked for counts
constexpr double same_torque = 1e-5;      // of the range: readings closer than this are repeats
constexpr double rounding = 1e-13;        // of the largest signal: no scatter
constexpr int fewest_for_scatter = 10;    // readings, to see whether the scatter changes
constexpr int fewest_for_outliers = 4;    // degrees of freedom
constexpr int fewest_for_hysteresis = 3;  // torques

constexpr std::size_t shown = 5;  // readings of one kind that are named

using Readings = std::span<const SensorReading>;

Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

std::string degree_name(int degree) {
  return degree == 1 ? "line" : degree == 2 ? "parabola" : "cubic";
}

std::string chance(double p) {
  return p < 1e-4 ? std::string("p < 0.0001") : fmt::format("p = {:.2g}", p);
}

/// Readings by torque, rising.
struct Level {
  double torque = 0.0, mean = 0.0;
  std::vector<std::size_t> readings{};
};

std::vector<Level> levels_of(Readings readings) {
  std::vector<double> torques;
  for (const SensorReading& r : readings) torques.push_back(r.torque);
  const auto [low, high] = std::minmax_element(torques.begin(), torques.end());
  const std::vector<double> starts = record::level_starts(torques, same_torque * (*high - *low));
  std::vector<Level> levels(starts.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    Level& level = levels[record::level_of(torques[i], starts)];
    level.readings.push_back(i);
    level.torque += torques[i];
    level.mean += readings[i].signal;
  }
  for (Level& level : levels) {
    level.torque /= static_cast<double>(level.readings.size());
    level.mean /= static_cast<double>(level.readings.size());
  }
  return levels;
}

class Calibrator {
 public:
  explicit Calibrator(Readings readings)
      : readings_(readings),
        levels_(levels_of(readings)),
        torque_(readings.size()),
        signal_(readings.size()) {
    for (std::size_t i = 0; i < readings.size(); ++i) {
      torque_[index(i)] = readings[i].torque;
      signal_[index(i)] = readings[i].signal;
    }
    floor_ = std::pow(rounding * signal_.cwiseAbs().maxCoeff(), 2) * count();
  }

  SensorCalibration calibrate(std::optional<int> degree) {
    require_readings(degree);
    best_ = best_degree();
    fit_ = polynomial(degree.value_or(best_));
    line_ = polynomial(1);
    require_a_sensor();
    set_sensor();
    look_for_higher_terms();
    look_for_lack_of_fit();
    look_for_hysteresis();
    look_for_uneven_scatter();
    look_for_outliers();
    note_repeated_rows();
    return result_;
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(readings_.size()); }
  [[nodiscard]] int torques() const { return static_cast<int>(levels_.size()); }
  [[nodiscard]] double percent(double signal) const {
    return 100.0 * std::abs(signal) / result_.signal_range;
  }

  void require_readings(std::optional<int> degree) const {
    if (degree && (*degree < 1 || *degree > highest_sensor_degree))
      throw std::invalid_argument(
          fmt::format("degree = {}: must be from 1 to {}", *degree, highest_sensor_degree));
    if (torques() < 2)
      throw std::invalid_argument(
          fmt::format("all {} readings are at one reference torque, {:.6g} N m: a line needs at "
                      "least two torques, and a test of the line needs three",
                      count(), readings_.front().torque));
    const int d = degree.value_or(1);
    if (torques() < d + 1 || count() < d + 2)
      throw std::invalid_argument(
          fmt::format("{} readings at {} reference torques: a {} needs at least {} readings at {} "
                      "torques, so that the scatter of the readings is known",
                      count(), torques(), degree_name(d), d + 2, d + 1));
  }

  /// Of the polynomials that leave readings and torques over.
  [[nodiscard]] int highest_degree() const {
    return std::max(1, std::min({highest_sensor_degree, torques() - 2, count() - 3}));
  }

  /// The chance that terms from `degree` on to the highest are scatter.
  [[nodiscard]] double higher_terms(const CurveFit& fit) const {
    const int degree = fit.degree(), highest = highest_degree();
    if (degree >= highest) return unset;
    const CurveFit all = polynomial(highest);
    return p_of_F(fit.square - all.square, highest - degree, all.square, all.degrees_of_freedom(),
                  floor_);
  }

  [[nodiscard]] int best_degree() const {
    int degree = 1;
    while (higher_terms(polynomial(degree)) < sensor_significance) ++degree;
    return degree;
  }

  [[nodiscard]] CurveFit polynomial(int degree) const {
    return fit_curve(torque_, signal_, degree);
  }

  void require_no_turn(const CurveFit& fit) const {
    if (const auto turn =
            turning_torque(fit.unscaled(), levels_.front().torque, levels_.back().torque))
      throw std::invalid_argument(
          fmt::format("the curve has a maximum or minimum at {:.4g} N m: one signal belongs to two "
                      "torques, so the program cannot calculate the torque from a signal",
                      *turn));
  }

  /// Every signal must belong to one torque, and change with it at all.
  void require_a_sensor() const {
    if (!fit_.unscaled().allFinite())
      throw std::invalid_argument(
          "the program cannot fit a curve to torques of this size and spread; check their unit");
    require_no_turn(fit_);
    if (higher_terms(fit_) < surely) require_no_turn(polynomial(best_));
    const double square = (signal_.array() - signal_.mean()).square().sum();
    const double p =
        p_of_F(square - line_.square, 1, line_.square, line_.degrees_of_freedom(), floor_);
    if (!(p < sensor_significance))
      throw std::invalid_argument(
          fmt::format("the signal does not follow the reference torque: a line explains {:.3g} % "
                      "of the variance of the signal ({}); is the signal column the right one?",
                      square > 0.0 ? 100.0 * (1.0 - line_.square / square) : 0.0, chance(p)));
  }

  void set_sensor() {
    TorqueSensor& s = result_.sensor;
    s.coefficients = fit_.unscaled();
    const double df = fit_.degrees_of_freedom();
    s.scatter = fit_.square > floor_ ? std::sqrt(fit_.square / df) : 0.0;
    set_covariance(s.scatter * s.scatter * fit_.inverse);
    s.lowest_torque = levels_.front().torque;
    s.highest_torque = levels_.back().torque;
    const auto by_signal = [](const auto& a, const auto& b) { return a.signal < b.signal; };
    const auto [low, high] = std::minmax_element(readings_.begin(), readings_.end(), by_signal);
    s.lowest_signal = low->signal;
    s.highest_signal = high->signal;
    result_.readings = count();
    result_.torques = torques();
    result_.degrees_of_freedom = fit_.degrees_of_freedom();
    result_.signal_range = std::abs(signal_at(s, s.highest_torque) - signal_at(s, s.lowest_torque));
    const Eigen::VectorXd straight = line_.unscaled();
    result_.off_line = result_.off_curve = 0.0;
    for (const Level& level : levels_) {
      result_.off_line = std::max(result_.off_line,
                                  std::abs(level.mean - straight[0] - straight[1] * level.torque));
      const double off = std::abs(level.mean - signal_at(s, level.torque));
      if (!(off >= result_.off_curve)) continue;
      result_.off_curve = off;
      result_.off_curve_at = level.torque;
    }
  }

  void set_covariance(const Eigen::MatrixXd& scaled) {
    TorqueSensor& s = result_.sensor;
    s.covariance = scaled;
    Eigen::VectorXd ends(s.coefficients.size());
    for (Eigen::Index k = 0; k < ends.size(); ++k) {
      const double unit = std::pow(fit_.scale, k);
      s.covariance.row(k) /= unit;
      s.covariance.col(k) /= unit;
      ends[k] = std::pow(levels_.back().torque, k) - std::pow(levels_.front().torque, k);
    }
    result_.range_std = std::sqrt(std::max(0.0, ends.dot(s.covariance * ends)));
  }

  void look_for_higher_terms() {
    const double p = result_.higher_terms_p_value = higher_terms(fit_);
    if (!(p < sensor_significance)) return;
    result_.warnings.push_back(record::note::misfit(fmt::format(
        "a {} differs from the readings by up to {:.3g} V, {:.2g} % of the signal "
        "range, at {:.4g} N m, which is more than chance explains ({}): use --degree {}",
        degree_name(result_.degree()), result_.off_curve, percent(result_.off_curve),
        result_.off_curve_at, chance(p), best_)));
  }

  void look_for_lack_of_fit() {
    LackOfFit& lack = result_.lack_of_fit;
    double pure = 0.0;
    for (const Level& level : levels_)
      for (const std::size_t i : level.readings)
        pure += std::pow(readings_[i].signal - level.mean, 2);
    const int p = static_cast<int>(fit_.coefficients.size());
    lack.degrees = torques() - p;
    lack.error_degrees = count() - torques();
    if (lack.error_degrees < 1) {
      result_.notes.push_back(
          record::note::unknown("no torque was read twice, so the scatter follows only from the "
                                "fit of a polynomial; read the same torques rising and falling"));
      return;
    }
    lack.repeatability = pure > floor_ ? std::sqrt(pure / lack.error_degrees) : 0.0;
    if (lack.degrees < 1) return;
    if (pure <= floor_) {
      result_.notes.push_back(record::note::unknown(
          "readings at the same torque are equal to the last digit: their scatter is below the "
          "resolution of the signal and cannot test the curve"));
      return;
    }
    const double misfit = std::max(0.0, fit_.square - pure);
    lack.statistic = misfit / lack.degrees / (pure / lack.error_degrees);
    lack.p_value = p_of_F(misfit, lack.degrees, pure, lack.error_degrees, floor_);
    // Where higher terms do better, that has been said.
    if (lack.p_value < sensor_significance && !(result_.higher_terms_p_value < sensor_significance))
      result_.warnings.push_back(record::note::misfit(fmt::format(
          "the means at each torque differ from the {} by up to {:.3g} V, {:.2g} % of the signal "
          "range, at {:.4g} N m, which is more than the scatter of repeated readings (F = {:.3g}, "
          "{})",
          degree_name(result_.degree()), result_.off_curve, percent(result_.off_curve),
          result_.off_curve_at, lack.statistic, chance(lack.p_value))));
  }

  /// +1 where the torque had risen to reading i, -1 where it had fallen; 0 at the first torque.
  [[nodiscard]] std::vector<int> loading() const {
    const double step = same_torque * (levels_.back().torque - levels_.front().torque);
    std::vector<int> way(readings_.size(), 0);
    for (std::size_t i = 1; i < readings_.size(); ++i) {
      const double change = readings_[i].torque - readings_[i - 1].torque;
      way[i] = change > step ? 1 : change < -step ? -1 : way[i - 1];
    }
    return way;
  }

  void look_for_hysteresis() {
    const std::vector<int> way = loading();
    Hysteresis& h = result_.hysteresis;
    std::vector<double> gaps;
    for (std::size_t l = 1; l + 1 < levels_.size(); ++l) {
      double up = 0.0, down = 0.0;
      int ups = 0, downs = 0;
      for (const std::size_t i : levels_[l].readings) {
        (way[i] > 0 ? up : down) += way[i] == 0 ? 0.0 : readings_[i].signal;
        ups += way[i] > 0;
        downs += way[i] < 0;
      }
      if (ups == 0 || downs == 0) continue;
      gaps.push_back(down / downs - up / ups);
      if (!(std::abs(gaps.back()) <= std::abs(h.largest))) {
        h.largest = gaps.back();
        h.largest_at = levels_[l].torque;
      }
    }
    h.torques = static_cast<int>(gaps.size());
    if (gaps.empty()) {
      result_.notes.push_back(
          record::note::unknown("no torque between the ends was read both rising and falling, so "
                                "the hysteresis is unknown"));
      return;
    }
    h.mean = 0.0;
    for (const double gap : gaps) h.mean += gap / h.torques;
    if (h.torques < fewest_for_hysteresis) return;
    double square = 0.0;
    for (const double gap : gaps) square += std::pow(gap - h.mean, 2);
    const double t2 = h.mean * h.mean * h.torques;
    h.p_value = p_of_F(t2, 1, square, h.torques - 1, floor_);  // the square of Student's t
    if (h.p_value < sensor_significance)
      result_.warnings.push_back(record::note::misfit(fmt::format(
          "hysteresis: the signal at falling torque differs from the signal at rising torque by "
          "{:+.3g} V on average and by {:+.3g} V ({:.2g} % of the signal range) at {:.4g} N m "
          "({}); the curve lies midway between rising and falling signal, and the scatter includes "
          "half of the difference",
          h.mean, h.largest, percent(h.largest), h.largest_at, chance(h.p_value))));
  }

  /// N R² of the squared residuals over the torque [Koenker1981].
  void look_for_uneven_scatter() {
    if (count() < fewest_for_scatter || result_.sensor.scatter == 0.0) return;
    Eigen::VectorXd squares = fit_.residuals.array().square() / fit_.free.array();
    Eigen::VectorXd torque = torque_.cwiseAbs();
    if (torque.minCoeff() == torque.maxCoeff()) return;  // no lower and no upper half
    const double middle = 0.5 * (torque.minCoeff() + torque.maxCoeff());
    double low = 0.0, high = 0.0;
    int lows = 0;
    for (Eigen::Index i = 0; i < torque.size(); ++i) {
      (torque[i] < middle ? low : high) += squares[i];
      lows += torque[i] < middle;
    }
    result_.scatter_low = std::sqrt(low / lows);
    result_.scatter_high = std::sqrt(high / (count() - lows));
    torque.array() -= torque.mean();
    squares.array() -= squares.mean();
    const double share =
        std::pow(torque.dot(squares), 2) / (torque.squaredNorm() * squares.squaredNorm());
    if (!std::isfinite(share)) return;
    const double p = result_.even_scatter_p_value = fit::chi_squared_above(1.0, count() * share);
    if (!(p < sensor_significance)) return;
    set_covariance(robust_covariance(fit_));
    result_.warnings.push_back(record::note::noise(
        fmt::format("the scatter of the signal is {:.3g} V in the lower half of the range and "
                    "{:.3g} V in the upper half ({}): the standard errors remain valid, but the "
                    "scatter of a single reading is only correct on average",
                    result_.scatter_low, result_.scatter_high, chance(p))));
  }

  /// Readings whose residual, of a fit without them, chance does not bring once in a hundred such
  /// calibrations.
  void look_for_outliers() {
    const int df = fit_.degrees_of_freedom() - 1;
    if (df + 1 < fewest_for_outliers || result_.sensor.scatter == 0.0) return;
    const double limit = fit::t_exceeded_with(df, 0.5 * sensor_significance / count());
    std::size_t found = 0;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      const double e = fit_.residuals[index(i)], free = fit_.free[index(i)];
      const double rest = fit_.square * free - e * e;
      const double t = rest > 0.0 ? std::abs(e) * std::sqrt(df / rest) : 0.0;
      if (!(t > limit) || ++found > shown) continue;
      result_.warnings.push_back(record::note::check_data(
          fmt::format("line {}: {:.6g} V at {:.6g} N m is {:+.3g} V off the curve, {:.3g} times "
                      "the scatter of the other readings; is it a typing error?",
                      readings_[i].line, readings_[i].signal, readings_[i].torque, e / free, t),
          {.line = readings_[i].line}));
    }
    if (found > shown)
      result_.warnings.push_back(record::note::check_data(fmt::format(
          "number of further readings that are too far off the curve: {}", found - shown)));
  }

  /// Torque and signal alike to the last digit are usually rows copied, at times a coarse signal.
  void note_repeated_rows() {
    std::vector<int> lines;
    for (const Level& level : levels_) {
      std::vector<SensorReading> sorted;
      for (const std::size_t i : level.readings) sorted.push_back(readings_[i]);
      const auto key = [](const SensorReading& r) {
        return std::tuple(r.torque, r.signal, r.line);
      };
      std::sort(sorted.begin(), sorted.end(),
                [&](const auto& a, const auto& b) { return key(a) < key(b); });
      for (std::size_t k = 1; k < sorted.size(); ++k)
        if (sorted[k].torque == sorted[k - 1].torque && sorted[k].signal == sorted[k - 1].signal)
          lines.push_back(sorted[k].line);
    }
    const std::size_t twins = lines.size();
    if (twins == 0) return;
    std::sort(lines.begin(), lines.end());
    lines.resize(std::min(twins, shown));
    result_.notes.push_back(record::note::assumed(fmt::format(
        "{} reading{} the same torque and signal as another one, to the last digit (line{} {}{}): "
        "they are treated as {}",
        twins, twins == 1 ? " has" : "s have", twins == 1 ? "" : "s", fmt::join(lines, ", "),
        twins > shown ? ", ..." : "", twins == 1 ? "a repeated reading" : "repeated readings")));
  }

  Readings readings_;
  std::vector<Level> levels_;
  Eigen::VectorXd torque_, signal_;
  double floor_ = 0.0;  // a sum of squares that is rounding [V²]
  int best_ = 1;
  CurveFit fit_{}, line_{};
  SensorCalibration result_{};
};

}  // namespace

double SensorCalibration::std(int coefficient) const {
  return std::sqrt(sensor.covariance(coefficient, coefficient));
}

SensorCalibration calibrate_sensor(Readings readings, std::optional<int> degree) {
  if (readings.empty()) throw std::invalid_argument("no readings");
  return Calibrator(readings).calibrate(degree);
}

}  // namespace raceway::rig
