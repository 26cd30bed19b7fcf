#include "rig/torque_sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace raceway::rig {
namespace {

/// Smaller ones are rounding; a record takes none [N m].
constexpr double least_std = 1e-12;

/// V'(M) inside of the range.
double slope(const Eigen::VectorXd& b, double torque) {
  double sum = 0.0;
  for (Eigen::Index k = b.size() - 1; k > 0; --k)
    sum = sum * torque + static_cast<double>(k) * b[k];
  return sum;
}

double polynomial(const Eigen::VectorXd& b, double torque) {
  double sum = 0.0;
  for (Eigen::Index k = b.size(); k-- > 0;) sum = sum * torque + b[k];
  return sum;
}

/// Where the polynomial is left for its tangent.
double inside(const TorqueSensor& s, double torque) {
  return std::clamp(torque, s.lowest_torque, s.highest_torque);
}

/// ∂V/∂b at a torque.
Eigen::VectorXd gradient(const TorqueSensor& s, double torque) {
  const double end = inside(s, torque);
  Eigen::VectorXd g(s.coefficients.size());
  double power = 1.0, lower = 0.0;  // M^k and k M^(k-1) at the end
  for (Eigen::Index k = 0; k < g.size(); ++k) {
    g[k] = power + lower * (torque - end);
    lower = static_cast<double>(k + 1) * power;
    power *= end;
  }
  return g;
}

/// M with V(M) = signal.
double inverse(const TorqueSensor& s, double signal) {
  const Eigen::VectorXd& b = s.coefficients;
  const double low = s.lowest_torque, high = s.highest_torque;
  const double at_low = polynomial(b, low), at_high = polynomial(b, high);
  const double share = (signal - at_low) / (at_high - at_low);
  if (share <= 0.0) return low + (signal - at_low) / slope(b, low);
  if (share >= 1.0) return high + (signal - at_high) / slope(b, high);
  const double chord = low + share * (high - low);
  if (b.size() == 2) return chord;
  std::uintmax_t steps = 100;
  return boost::math::tools::newton_raphson_iterate(
      [&](double m) { return std::tuple(polynomial(b, m) - signal, slope(b, m)); }, chord, low,
      high, std::numeric_limits<double>::digits - 2, steps);
}

/// "3.1" or "3.1 to 4.2", in N mm.
std::string span_text(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string low = fmt::format("{:.3g}", *least / N_mm);
  const std::string high = fmt::format("{:.3g}", *most / N_mm);
  return low == high ? low : low + " to " + high;
}

/// Signals beyond those of the calibration: how many, where, how far.
std::string note_outside(const TorqueSensor& s, std::span<const double> signals,
                         std::span<const int> lines) {
  constexpr std::size_t most_named = 5;
  std::size_t count = 0, all = 0;
  std::string places;
  double least = s.lowest_signal, most = s.highest_signal;
  for (std::size_t row = 0; row < signals.size(); ++row) {
    if (std::isnan(signals[row])) continue;
    ++all;
    least = std::min(least, signals[row]);
    most = std::max(most, signals[row]);
    if (signals[row] >= s.lowest_signal && signals[row] <= s.highest_signal) continue;
    if (++count <= most_named && row < lines.size())
      places += fmt::format("{}{}", places.empty() ? "" : ", ", lines[row]);
  }
  if (count == 0) return {};
  std::string reach;
  if (least < s.lowest_signal) reach = fmt::format("down to {:.5g}", least);
  if (most > s.highest_signal)
    reach += fmt::format("{}up to {:.5g}", reach.empty() ? "" : " and ", most);
  return fmt::format(
      "signals outside the calibrated range of {:.5g} to {:.5g} V: {} of {}, {} V (line{} {}{}); "
      "the program extrapolates their torques along the tangent at the end of the range",
      s.lowest_signal, s.highest_signal, count, all, reach, count == 1 ? "" : "s", places,
      count > most_named ? ", ..." : "");
}

}  // namespace

std::optional<double> turning_torque(const Eigen::VectorXd& b, double lowest, double highest) {
  const double sign = slope(b, lowest);
  if (sign == 0.0 || !std::isfinite(sign)) return lowest;
  std::array<double, 2> extremes{highest, highest};
  // Of the slope, a parabola, within the range.
  if (b.size() == 4 && b[3] != 0.0) extremes[0] = std::clamp(-b[2] / (3.0 * b[3]), lowest, highest);
  for (const double end : extremes) {
    const double there = slope(b, end);
    if (there * sign > 0.0) continue;
    if (there == 0.0 || !std::isfinite(there)) return end;
    std::uintmax_t steps = 200;
    const auto [a, z] = boost::math::tools::toms748_solve(
        [&](double m) { return slope(b, m); }, lowest, end, sign, there,
        boost::math::tools::eps_tolerance<double>(40), steps);
    return 0.5 * (a + z);
  }
  return std::nullopt;
}

double signal_at(const TorqueSensor& s, double torque) {
  const double end = inside(s, torque);
  return polynomial(s.coefficients, end) + slope(s.coefficients, end) * (torque - end);
}

bool same_torques(const TorqueSensor& a, const TorqueSensor& b) {
  return a.coefficients.size() == b.coefficients.size() && a.coefficients == b.coefficients &&
         a.lowest_torque == b.lowest_torque && a.highest_torque == b.highest_torque &&
         a.zero == b.zero;
}

SensedTorque torque_of(const TorqueSensor& s, double signal, double signal_std) {
  const double shift = s.zero ? signal_at(s, 0.0) - *s.zero : 0.0;
  const double torque = inverse(s, signal + shift);
  const double gain = slope(s.coefficients, inside(s, torque));
  Eigen::VectorXd g = gradient(s, torque);
  double variance = 0.0;
  if (s.zero) {
    g -= gradient(s, 0.0);
    variance = std::pow(s.zero_std.value_or(s.scatter), 2);
  }
  variance += std::max(0.0, g.dot(s.covariance * g));
  const double own = std::isnan(signal_std) ? s.scatter : signal_std;
  return {torque, std::sqrt(variance + own * own) / std::abs(gain),
          std::sqrt(variance) / std::abs(gain)};
}

SensedTorques sensed_torques(const TorqueSensor& sensor, std::span<const double> signals,
                             std::span<const double> deviations, std::span<const int> lines) {
  SensedTorques result;
  std::vector<double> std, common;
  for (std::size_t row = 0; row < signals.size(); ++row) {
    const bool read = !std::isnan(signals[row]);
    const SensedTorque one =
        read ? torque_of(sensor, signals[row], deviations.empty() ? unset : deviations[row])
             : SensedTorque{unset, unset, unset};
    result.torque.push_back(one.torque);
    result.std.push_back(one.std);
    if (!read) continue;
    std.push_back(one.std);
    common.push_back(one.common);
  }
  if (std.empty()) return result;
  const std::string from =
      fmt::format("[torque_sensor]{} converts torque_signal_V to the friction torque",
                  sensor.source.empty() ? "" : " (" + sensor.source + ")");
  if (*std::min_element(std.begin(), std.end()) < least_std) {
    result.std.clear();
    result.notes.push_back(record::note::unknown(
        from + ": the readings of the calibration have no scatter, so the rows have no std_Nmm",
        {.key = "torque_sensor"}));
  } else {
    result.notes.push_back(record::note::read_as(
        fmt::format(
            "{}: std_Nmm of a row is {} N mm, of which {} N mm comes from the calibration{}: this "
            "part is common to all rows, and averaging does not reduce it",
            from, span_text(std), span_text(common), sensor.zero ? " and zero_V" : ""),
        {.key = "torque_sensor"}));
  }
  if (std::string note = note_outside(sensor, signals, lines); !note.empty())
    result.notes.push_back(record::note::read_as(std::move(note), {.key = "torque_sensor"}));
  return result;
}

}  // namespace raceway::rig
