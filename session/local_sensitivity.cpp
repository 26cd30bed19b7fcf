#include "session/detail/local_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/parameters.h"
#include "text/error.h"

namespace raceway::session::varied {

using results::LocalSensitivity;
using results::VariedDatum;

namespace {

constexpr double usual_share = 0.01;  // of a value
constexpr double usual_kelvin = 1.0;
constexpr double step_of_usual = 0.1;

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return x == y || (std::isnan(x) && std::isnan(y));
         });
}

/// Slope of f through f(0) and f(h), f(h/2) on one side, of second order.
double one_sided_slope(double f0, double whole, double half, double h) {
  return (4.0 * half - whole - 3.0 * f0) / h;
}

/// Smaller differences are not told from the ends of iterations.
constexpr double least_told = 1e-4;  // of the largest change of a prediction

void look_at_steps(const VariedDatum& datum, const Around& around, std::size_t i, double f0,
                   LocalSensitivity& local) {
  const auto value = [&](std::size_t which) {
    const Outcome& one = around.at[which];
    return one.refused.empty() ? one.values[i] : unset;
  };
  const double h = around.step, up = value(0), down = value(1), up_2 = value(2), down_2 = value(3);
  local.high = datum.spread > 0.0 ? value(4) : f0;
  local.low = datum.spread > 0.0 ? value(5) : f0;
  if (datum.whole) {
    local.one_sided = std::isnan(up) || std::isnan(down);
    local.derivative = std::isnan(up)     ? (f0 - down) / h
                       : std::isnan(down) ? (up - f0) / h
                                          : (up - down) / (2.0 * h);
    return;
  }
  if (std::isnan(up) || std::isnan(up_2) || std::isnan(down) || std::isnan(down_2)) {
    local.one_sided = true;
    const bool above = std::isfinite(up) && std::isfinite(up_2);
    const double side = above ? h : -h, whole = above ? up : down, half = above ? up_2 : down_2;
    local.derivative = one_sided_slope(f0, whole, half, side);
    // Of a smooth prediction its curvature, which the extrapolation takes off.
    local.derivative_error = std::fabs(local.derivative - (half - f0) / (0.5 * side));
    return;
  }
  const double coarse = (up - down) / (2.0 * h), fine = (up_2 - down_2) / h;
  local.derivative = (4.0 * fine - coarse) / 3.0;
  local.derivative_error = std::fabs(local.derivative - fine);
}

/// Where slopes to both sides differ, and do so as much with half the step, the prediction has a
/// kink.
void look_for_kinks(const VariedDatum& datum, const Around& around, std::size_t i, double f0,
                    double largest, LocalSensitivity& local) {
  if (datum.whole || !std::isfinite(local.derivative)) return;
  const double h = around.step, size = datum.spread > 0.0 ? datum.spread : h;
  const double told = std::fmax(0.02 * std::fabs(local.derivative) * size, least_told * largest);
  local.steps_disagree = local.derivative_error * size > told;
  if (local.one_sided) return;
  const auto value = [&](std::size_t which) { return around.at[which].values[i]; };
  const double bend = std::fabs(value(0) - 2.0 * f0 + value(1)) / h;
  const double bend_2 = std::fabs(value(2) - 2.0 * f0 + value(3)) / (0.5 * h);
  local.kink = bend_2 * size > told && bend_2 > 0.7 * bend;
}

double usual_spread(const VariedDatum& datum, std::string& from) {
  if (datum.whole) {
    from = "1";
    return 1.0;
  }
  if (datum.name.ends_with("_C")) {
    from = "1 K";
    return usual_kelvin;
  }
  from = "1 %";
  return usual_share * std::fabs(datum.value);
}

/// Standard errors of fitted numbers, as far as the model carries them.
void take_standard_errors(const model::Model& model, Data& data) {
  if (!model.covariance) return;
  const std::vector<record::Parameter> known = model::parameters(model);
  for (std::size_t k = 0; k < model.covariance->names.size(); ++k)
    for (const record::Parameter& p : known) {
      if (p.name != model.covariance->names[k]) continue;
      for (const std::string& address : p.addresses) {
        const bool of_effect = address.starts_with("effect.");
        for (VariedDatum& d : data.all()) {
          if (d.name != (of_effect ? p.name : address)) continue;
          d.spread = std::sqrt(3.0) * model.covariance->std(k);
          d.spread_from = "standard error";
        }
      }
    }
}

}  // namespace

void take_spreads(const model::Model& model, const SensitivityQuestion& q, Data& data) {
  take_standard_errors(model, data);
  for (const files::SpreadText& text : q.spreads) {
    VariedDatum& datum = data.all()[data.find(text.name)];
    datum.spread = files::spread_of(text, datum.value);
    datum.spread_from = "given";
    if (datum.whole && datum.spread != std::floor(datum.spread))
      throw text::InputError(
          fmt::format(
              "spread of {} = {}: must be a whole number, because the varied quantity is a count",
              text.name, text.text),
          {.key = text.name});
  }
}

std::vector<Around> predict_around(Data& data, const Predictor& predictor,
                                   const SensitivityQuestion& q, results::Sensitivity& s) {
  std::vector<Around> around(data.all().size());
  for (std::size_t k = 0; k < around.size(); ++k) {
    VariedDatum& datum = data.all()[k];
    std::string from;
    double usual = usual_spread(datum, from);
    if (std::isnan(datum.spread)) {
      datum.spread = usual;
      datum.spread_from = from;
    }
    if (usual == 0.0) usual = datum.spread;
    around[k].step = datum.whole ? 1.0 : q.steady ? usual : step_of_usual * usual;
    if (!data.is_asked(k))
      around[k].step = 0.0;
    else if (around[k].step == 0.0)
      s.not_varied.emplace_back(datum.name,
                                "its value is 0, so the default spread of 1 % is 0; give a spread");
  }
  constexpr std::array<double, 4> shares{1.0, -1.0, 0.5, -0.5};
  for_all(around.size() * 6, q, 0.0, q.samples > 0 ? 0.1 : 1.0, [&](std::size_t i) {
    const std::size_t k = i / 6, which = i % 6;
    const VariedDatum& datum = data.all()[k];
    Around& one = around[k];
    const double by = which < 4    ? shares[which] * one.step
                      : which == 4 ? datum.spread
                                   : -datum.spread;
    if (one.step == 0.0 || (which >= 4 && datum.spread == 0.0) ||
        (datum.whole && (which == 2 || which == 3)))
      return;
    const std::pair<std::size_t, double> change{k, datum.value + by};
    one.at[which] = data.predict(predictor, {&change, 1});
  });
  return around;
}

std::vector<std::size_t> take_what_enters(const Data& data, const std::vector<Around>& around,
                                          const std::vector<double>& here, bool sampled,
                                          results::Sensitivity& s) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Around& one = around[k];
    if (one.step == 0.0) continue;
    bool enters = false;
    std::string refused, spread_refused;
    for (std::size_t which = 0; which < one.at.size(); ++which) {
      const Outcome& outcome = one.at[which];
      if (!outcome.refused.empty())
        (which >= 4 ? spread_refused : refused) = outcome.refused;
      else if (!outcome.values.empty())
        enters = enters || !same(outcome.values, here);
    }
    // A slope needs both steps of one side.
    const auto has = [&](std::size_t which) { return !one.at[which].values.empty(); };
    const bool taken =
        data.all()[k].whole ? has(0) || has(1) : (has(0) && has(2)) || (has(1) && has(3));
    const VariedDatum& datum = data.all()[k];
    if (!taken) {
      s.not_varied.emplace_back(datum.name, refused);
      continue;
    }
    if (!enters) {
      s.does_not_enter.push_back(datum.name);
      continue;
    }
    const bool given = datum.spread_from == "given";
    if (!spread_refused.empty() && sampled && given)
      throw text::InputError(
          fmt::format("spread of {} = {:.6g} ({}): the varied model is not valid: {}", datum.name,
                      datum.spread, datum.spread_from, spread_refused),
          {.key = datum.name});
    if (!spread_refused.empty() && sampled)
      s.not_sampled.emplace_back(datum.name, spread_refused);
    else if (datum.spread > 0.0)
      s.sampled.push_back(places.size());
    places.push_back(k);
    s.data.push_back(datum);
  }
  return places;
}

void differentiate(std::size_t i, const std::vector<VariedDatum>& data,
                   const std::vector<std::size_t>& places, const std::vector<Around>& around,
                   results::PredictionSensitivity& p) {
  double largest = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    LocalSensitivity local;
    const VariedDatum& datum = data[k];
    // An outcome that was not asked for has no values: a count has no second step.
    Around one = around[places[k]];
    for (Outcome& o : one.at)
      if (o.values.empty()) o.values.assign(i + 1, unset);
    look_at_steps(datum, one, i, p.value, local);
    local.change = local.derivative * datum.spread;
    if (datum.has_elasticity) local.elasticity = local.derivative * datum.value / p.value;
    if (std::isfinite(local.change)) {
      largest = std::fmax(largest, std::fabs(local.change));
      squares += local.change * local.change;
    }
    p.local.push_back(local);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    LocalSensitivity& local = p.local[k];
    if (squares > 0.0) local.share = local.change * local.change / squares;
    look_for_kinks(data[k], around[places[k]], i, p.value, largest, local);
  }
  p.order.resize(places.size());
  std::iota(p.order.begin(), p.order.end(), std::size_t{0});
  std::stable_sort(p.order.begin(), p.order.end(), [&](std::size_t a, std::size_t b) {
    const double x = std::fabs(p.local[a].change), y = std::fabs(p.local[b].change);
    return std::isnan(x) != std::isnan(y) ? std::isnan(y) : x > y;
  });
}

}  // namespace raceway::session::varied
