#include "correction/transfer_function.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string_view>

#include "algebra/detail/decompositions.h"
#include "record/digits.h"

namespace raceway::correction {
namespace {

using Coefficients = std::vector<double>;

double sum(const Coefficients& c) { return std::accumulate(c.begin(), c.end(), 0.0); }

/// True where 1 is a root, but for rounding.
bool has_root_at_one(const Coefficients& c) {
  const double size =
      std::accumulate(c.begin(), c.end(), 0.0, [](double s, double x) { return s + std::abs(x); });
  return c.size() > 1 && std::abs(sum(c)) <= 1e-14 * size;
}

/// Without the factor (1 - z^-1).
Coefficients divided_by_root_at_one(const Coefficients& c) {
  Coefficients quotient(c.size() - 1);
  std::partial_sum(c.begin(), c.end() - 1, quotient.begin());
  for (double& q : quotient) q = record::with_digits(q, 15);
  return quotient;
}

std::vector<std::complex<double>> poles_of(const Coefficients& denominator) {
  const auto n = static_cast<Eigen::Index>(denominator.size()) - 1;
  if (n == 0) return {};
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
    companion(0, k) = -denominator[static_cast<std::size_t>(k) + 1];
  companion.bottomLeftCorner(n - 1, n - 1).setIdentity();
  const Eigen::VectorXcd roots = algebra::eigenvalues(companion);
  std::vector<std::complex<double>> poles(roots.begin(), roots.end());
  std::sort(poles.begin(), poles.end(), [](const auto& a, const auto& b) {
    return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a.real() > b.real();
  });
  return poles;
}

using Extended = long double;

/// c0 + c1 x + c2 x² ...
Extended polynomial(const std::vector<Extended>& c, Extended x) {
  Extended value = 0;
  for (std::size_t k = c.size(); k-- > 0;) value = value * x + c[k];
  return value;
}

/// z^n b(1/z) over d = 1 - z: small numbers where z is close to 1, so that no digit of d is lost.
std::vector<Extended> about_one(const Coefficients& b) {
  std::vector<Extended> c(b.size(), 0);
  // Horner's scheme over z = 1 - d.
  for (const double coefficient : b) {
    for (std::size_t k = c.size(); k-- > 1;) c[k] -= c[k - 1];
    // What was c (1 - d) is now complete; the next coefficient joins the constant.
    c[0] += coefficient;
  }
  return c;
}

Extended slope(const std::vector<Extended>& c, Extended x) {
  Extended value = 0;
  for (std::size_t k = c.size(); k-- > 1;) value = value * x + static_cast<Extended>(k) * c[k];
  return value;
}

/// 1 - pole, from a start that has lost digits.
Extended polished(const std::vector<Extended>& c, Extended start) {
  for (int i = 0; i < 20; ++i) {
    const Extended steep = slope(c, start);
    if (steep == 0) break;
    const Extended step = polynomial(c, start) / steep;
    start -= step;
    if (std::abs(step) <= 1e-18L * std::abs(start)) break;
  }
  return start;
}

/// Half of the last digit with which a number is written down.
double half_of_last_digit(double x) {
  if (x == 0.0) return 0.0;
  char text[32];
  const auto end =
      std::to_chars(std::begin(text), std::end(text), std::abs(x), std::chars_format::scientific)
          .ptr;
  const std::string_view written(text, static_cast<std::size_t>(end - text));
  const std::size_t e = written.find('e');
  const int decimals = e > 1 ? static_cast<int>(e) - 2 : 0;
  return 0.5 * std::pow(10.0, std::stoi(std::string(written.substr(e + 1))) - decimals);
}

/// Fills in what rounding of the printed digits leaves open.
void draw_roundings(const TransferFunction& printed, TransferFunctionCheck& result) {
  constexpr int draws = 4000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  const auto rounded = [&](Coefficients c, std::size_t first) {
    for (std::size_t k = first; k < c.size(); ++k) c[k] += even(random) * half_of_last_digit(c[k]);
    return c;
  };
  std::vector<double> gains;
  int unstable = 0;
  for (int i = 0; i < draws; ++i) {
    const Coefficients a = rounded(printed.numerator, 0), b = rounded(printed.denominator, 1);
    gains.push_back(sum(a) / sum(b));
    const auto poles = poles_of(b);
    if (!poles.empty() && std::abs(poles.front()) >= 1.0) ++unstable;
  }
  std::sort(gains.begin(), gains.end());
  result.dc_gain_lower = gains[draws / 20];
  result.dc_gain_upper = gains[draws - draws / 20 - 1];
  result.unstable_share = static_cast<double>(unstable) / draws;
}

double single_error(const TransferFunction& printed, double dc_gain) {
  const auto steps = static_cast<std::size_t>(std::clamp(144000.0 / printed.sampling, 1.0, 2e6));
  const std::vector<float> step(steps, 1.0F);
  const std::vector<double> exact_step(steps, 1.0);
  const double reached = run_single(printed, step).back();
  return (reached - run(printed, exact_step).back()) / std::abs(dc_gain);
}

using Poles = std::vector<std::complex<double>>;

/// `poles`: the largest first.
bool on_or_outside_the_circle(const Poles& poles) {
  return !poles.empty() && std::abs(poles.front()) >= 1.0 - 1e-12;
}

std::vector<std::string> warnings_of(const Poles& poles) {
  std::vector<std::string> result;
  if (on_or_outside_the_circle(poles))
    result.emplace_back("pole on or outside the unit circle: the response never decays");
  if (std::any_of(poles.begin(), poles.end(),
                  [](const auto& p) { return p.imag() == 0.0 && p.real() < 0.0; }))
    result.emplace_back(
        "negative real pole: the output changes its sign from sample to sample, which no thermal "
        "body does");
  if (std::any_of(poles.begin(), poles.end(), [](const auto& p) { return p.imag() != 0.0; }))
    result.emplace_back("complex poles: the output oscillates, which no thermal body does");
  return result;
}

std::vector<std::string> warnings(const TransferFunctionCheck& c, double quantum,
                                  std::string_view unit) {
  constexpr double visible = 0.1 * um;
  std::vector<std::string> result = warnings_of(c.poles);
  if (c.unstable_share > 0.0)
    result.push_back(
        fmt::format("rounding of the printed digits can make the response unstable (in {:.1f} % of "
                    "4000 random draws)",
                    100.0 * c.unstable_share));
  if (c.dc_gain_upper - c.dc_gain_lower > 0.2 * std::abs(c.dc_gain))
    result.push_back(
        fmt::format("DC gain not determined by the printed digits: {:.4g} {} per unit of the "
                    "input, but {:.4g} to {:.4g} is possible (5th to 95th percentile)",
                    c.dc_gain / um, unit, c.dc_gain_lower / um, c.dc_gain_upper / um));
  if (std::abs(c.feedthrough) * quantum > visible)
    result.push_back(
        fmt::format("feedthrough turns a step of the last digit of the input ({:g}) into a "
                    "displacement step of {:.3g} {}",
                    quantum, c.feedthrough * quantum / um, unit));
  if (!(std::abs(c.single_error) <= 0.01))
    result.push_back(fmt::format(
        "in single precision, the step response after 40 h has an error of {:.1f} % of the DC gain",
        100.0 * std::abs(c.single_error)));
  return result;
}

}  // namespace

TransferFunction reduced(const TransferFunction& printed) {
  if (printed.numerator.empty() || printed.denominator.empty())
    throw std::invalid_argument("a transfer function needs a numerator and a denominator");
  for (const Coefficients* c : {&printed.numerator, &printed.denominator})
    if (!std::all_of(c->begin(), c->end(), [](double x) { return std::isfinite(x); }))
      throw std::invalid_argument("a coefficient is not finite");
  if (printed.denominator.front() != 1.0)
    throw std::invalid_argument("the denominator must begin with 1");
  if (!(printed.sampling > 0.0))
    throw std::invalid_argument(
        "a transfer function needs the sampling interval for which it is valid");
  TransferFunction result = printed;
  while (has_root_at_one(result.numerator) && has_root_at_one(result.denominator)) {
    result.numerator = divided_by_root_at_one(result.numerator);
    result.denominator = divided_by_root_at_one(result.denominator);
  }
  return result;
}

TransferFunction direct_form(const TransferFunction& printed, double unit) {
  TransferFunction f = reduced(printed);
  for (double& a : f.numerator) a = record::with_digits(a * unit / um, 15);
  const std::size_t order = std::max(f.numerator.size(), f.denominator.size());
  f.numerator.resize(order);
  f.denominator.resize(order);
  return f;
}

std::vector<std::string> pole_warnings(const TransferFunction& printed) {
  return warnings_of(poles_of(reduced(printed).denominator));
}

bool never_decays(const TransferFunction& printed) {
  return on_or_outside_the_circle(poles_of(reduced(printed).denominator));
}

std::vector<double> run(const TransferFunction& printed, std::span<const double> input) {
  const TransferFunction f = reduced(printed);
  const std::size_t order = std::max(f.numerator.size(), f.denominator.size());
  Coefficients a = f.numerator, b = f.denominator;
  a.resize(order);
  b.resize(order);
  // Transposed direct form: one state per past sample.
  std::vector<double> state(order, 0.0), output(input.size());
  for (std::size_t k = 0; k < input.size(); ++k) {
    const double y = output[k] = a[0] * input[k] + state[0];
    for (std::size_t i = 1; i < order; ++i)
      state[i - 1] = (i + 1 < order ? state[i] : 0.0) + a[i] * input[k] - b[i] * y;
  }
  return output;
}

std::vector<float> run_single(const TransferFunction& printed, std::span<const float> input) {
  const std::vector<float> a(printed.numerator.begin(), printed.numerator.end());
  const std::vector<float> b(printed.denominator.begin(), printed.denominator.end());
  std::vector<float> output(input.size());
  for (std::size_t k = 0; k < input.size(); ++k) {
    float y = 0.0F;
    for (std::size_t i = 0; i < a.size() && i <= k; ++i) y += a[i] * input[k - i];
    for (std::size_t i = 1; i < b.size() && i <= k; ++i) y -= b[i] * output[k - i];
    output[k] = y;
  }
  return output;
}

ParallelForm parallel_form(const TransferFunction& printed) {
  TransferFunction f = reduced(printed);
  const auto shorten = [](Coefficients& c) {
    while (c.size() > 1 && c.back() == 0.0) c.pop_back();
  };
  shorten(f.numerator);
  shorten(f.denominator);
  const std::size_t order = f.denominator.size() - 1;
  if (f.numerator.size() > order + 1)
    throw std::invalid_argument(
        "the numerator has more coefficients than the denominator, so a part of the response ends "
        "after some samples; a sum of lags has no such part");
  const std::vector<Extended> shifted = about_one(f.denominator);
  std::vector<Extended> rates;  // 1 - pole
  for (const std::complex<double>& p : poles_of(f.denominator)) {
    if (p.imag() != 0.0)
      throw std::invalid_argument(fmt::format(
          "the poles {:.6g} +- {:.3g}i are complex, but a sum of lags has only real poles",
          p.real(), std::abs(p.imag())));
    const Extended rate = polished(shifted, 1.0L - static_cast<Extended>(p.real()));
    if (!(rate > 0 && rate < 1))
      throw std::invalid_argument(
          fmt::format("the pole {:.10g} is not between 0 and 1, so it has no time constant",
                      static_cast<double>(1 - rate)));
    for (const Extended other : rates)
      if (std::abs(rate - other) <= 1e-6L * rate)
        throw std::invalid_argument(
            fmt::format("the pole {:.10g} occurs twice, but parallel lags need different poles",
                        static_cast<double>(1 - rate)));
    rates.push_back(rate);
  }
  // a(x)/prod(1 - p x), x = 1/z: the share of a pole is a(1/p)/prod(1 - q/p) over the others.
  ParallelForm form;
  const std::vector<Extended> a(f.numerator.begin(), f.numerator.end());
  form.through = f.numerator.front();
  for (const Extended rate : rates) {
    const Extended pole = 1 - rate;
    Extended share = polynomial(a, 1 / pole);
    for (const Extended other : rates)
      if (other != rate) share *= pole / (other - rate);
    form.lags.push_back({static_cast<double>(rate), static_cast<double>(share * pole / rate)});
  }
  return form;
}

TransferFunctionCheck check(const TransferFunction& printed, double quantum,
                            std::string_view unit) {
  const TransferFunction f = reduced(printed);
  TransferFunctionCheck result;
  result.poles = poles_of(printed.denominator);
  for (const std::complex<double>& p : result.poles)
    result.time_constants.push_back(p.imag() == 0.0 && p.real() > 0.0 && p.real() < 1.0 - 1e-12
                                        ? -printed.sampling / std::log(p.real())
                                        : unset);
  result.dc_gain = sum(f.numerator) / sum(f.denominator);
  result.feedthrough = printed.numerator.front();
  draw_roundings(printed, result);
  result.single_error = single_error(printed, result.dc_gain);
  result.warnings = warnings(result, quantum, unit);
  return result;
}

}  // namespace raceway::correction
