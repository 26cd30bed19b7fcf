#include "tests/hidden_effect/oracle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/hidden_effect/likelihood.h"

namespace hidden_effect {
namespace {

constexpr double alarm_level = 0.01;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains(const std::vector<std::string_view>& ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// The datum that the mistake makes wrong. Nothing: the oracle has no formula for the mistake.
std::optional<const Datum*> datum_of(const Mistake& m) {
  if (m.viscosity_40 > 0.0 || m.sensor_scatter > 0.0 || m.in_fahrenheit || m.in_kilograms ||
      m.pair_preload > 0.0 || m.support_constant > 0.0 || m.support_viscous > 0.0 ||
      m.hysteresis > 0.0)
    return std::nullopt;
  std::string_view id;
  if (m.creep > 0.0) id = "torque-creep";
  if (m.cell_drift > 0.0) id = "load-cell-drift";
  if (m.sensor_offset != 0.0) id = "temperature-offset";
  if (m.rise_seen != 1.0) id = "temperature-gain";
  for (const Datum& d : data_of_the_files())
    if (d.id == id) return &d;
  return nullptr;
}

/// The rows with the recorded temperatures: the oracle corrects them by a datum, as a user would.
std::vector<Reading> as_recorded(std::span<const Reading> rows) {
  std::vector<Reading> seen(rows.begin(), rows.end());
  for (Reading& r : seen) r.point.temperature = r.seen;
  return seen;
}

Eigen::VectorXd measured(std::span<const Reading> rows) {
  Eigen::VectorXd y(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index i = 0; i < y.size(); ++i) y[i] = rows[static_cast<std::size_t>(i)].measured;
  return y;
}

/// The value that chance exceeds in 1 %.
double limit_of_chi_squared(double degrees) {
  return boost::math::quantile(
      boost::math::complement(boost::math::chi_squared(degrees), alarm_level));
}

/// Products of a figure of two rows where both are of one run.
Eigen::MatrixXd common_to_runs(std::span<const Reading> rows, double (*figure)(const Reading&)) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd common = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const Reading &a = rows[static_cast<std::size_t>(i)], &b = rows[static_cast<std::size_t>(k)];
      if (a.run == b.run) common(i, k) = figure(a) * figure(b);
    }
  return common;
}
double one(const Reading&) { return 1.0; }
double size_of(const Reading& r) { return std::abs(r.torque); }

/// The least -2 ln L of a hypothesis where the noise has a further part of unknown size.
double least_with_scatter(const Rig& rig, std::span<const Reading> rows,
                          const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& part,
                          const Hypothesis& hypothesis) {
  const auto cost = [&](double log_size) {
    const Likelihood scattered(rig, rows, measured(rows),
                               covariance + std::exp(2.0 * log_size) * part);
    return scattered.least(hypothesis) + scattered.log_determinant();
  };
  constexpr int bits = 12;
  const double typical = 0.5 * std::log(covariance.trace() / part.trace());
  return boost::math::tools::brent_find_minima(cost, typical - 4.0, typical + 3.0, bits).second;
}

struct Scored {
  double cost = infinity;
  std::string name{};
  void take(double other, std::string name_of_other) {
    if (other < cost) *this = {other, std::move(name_of_other)};
  }
};

}  // namespace

bool OracleAnswer::detects() const {
  return something ? detection > detected_from : -lead > needed;
}
bool OracleAnswer::includes() const {
  return something ? gain > needed && lead >= -within_reach : -lead <= needed;
}
bool OracleAnswer::decides() const {
  return something ? gain > needed && lead > within_reach : -lead <= needed;
}

bool OracleAnswer::misnames() const {
  return something ? gain - lead > needed && lead < -within_reach : -lead > needed;
}

std::optional<OracleAnswer> ask_oracle(const Rig& rig, std::span<const Reading> rows) {
  const Setup& setup = rig.setup;
  const std::optional<const Datum*> datum = datum_of(setup.mistake);
  Hypothesis truth;
  for (const Hidden& h : rig.hidden) truth.effects.push_back(h.effect);
  if (datum) truth.datum = *datum;
  const std::size_t causes = truth.effects.size() + (truth.datum == nullptr ? 0 : 1);
  if (!datum || setup.logger.rows > 0 || setup.plan == Plan::cycling || causes > 2 ||
      (truth.datum != nullptr && causes > 1))
    return std::nullopt;

  const std::vector<Reading> seen = as_recorded(rows);
  const Eigen::MatrixXd covariance = covariance_of_noise(rig, rows);
  const Likelihood likelihood(rig, seen, measured(rows), covariance);
  const double nothing = likelihood.least({}), true_cost = likelihood.least(truth);

  // Ids that name the truth, alone.
  std::vector<std::string_view> right = rig.accepted();
  if (truth.datum != nullptr) right.push_back(truth.datum->id);
  std::vector<const Effect*> entries;
  for (const Effect& e : catalogue_effects())
    if (!setup.law.contacts || !within_contacts(e.id)) entries.push_back(&e);
  Scored single, right_single, wrong_single;
  double excess = infinity;
  const auto degrees =
      static_cast<double>(rows.size()) - static_cast<double>(likelihood.base_numbers());
  const auto score = [&](const Hypothesis& one, std::string_view id) {
    const double cost = likelihood.least(one);
    excess = std::min(excess, cost - limit_of_chi_squared(degrees - one.numbers()));
    single.take(cost, std::string(id));
    (contains(right, id) ? right_single : wrong_single).take(cost, std::string(id));
  };
  for (const Effect* e : entries) score({.effects = {e}}, e->id);
  for (const Datum& d : data_of_the_files()) score({.datum = &d}, d.id);
  if (truth.datum != nullptr && truth.datum->id == "torque-creep") {
    wrong_single.take(least_with_scatter(rig, seen, covariance, common_to_runs(seen, one), {}) -
                          likelihood.log_determinant(),
                      "zeros of the runs");
    wrong_single.take(nothing, "nothing");
  }

  OracleAnswer answer;
  answer.something = causes > 0;
  const auto tried = static_cast<double>(entries.size() + data_of_the_files().size());
  answer.needed =
      std::log(static_cast<double>(rows.size())) + 2.0 * std::log(causes > 1 ? tried - 1.0 : tried);
  answer.detection = nothing - true_cost;
  if (causes > 0) answer.detected_from = limit_of_chi_squared(truth.numbers());
  answer.gain = (causes > 1 ? std::min(nothing, single.cost) : nothing) - true_cost;
  if (causes == 1 && truth.datum == nullptr && truth.effects.front()->kind == Kind::outside)
    answer.misfit_excess = excess;
  if (truth.datum != nullptr && setup.noise == Noise::run_offsets) {
    const Eigen::MatrixXd offsets = common_to_runs(seen, size_of);
    const Eigen::MatrixXd rest = covariance - setup.detail.offset * setup.detail.offset * offsets;
    answer.learned_detection = least_with_scatter(rig, seen, rest, offsets, {}) -
                               least_with_scatter(rig, seen, rest, offsets, truth);
    // z and the cause come from the differences of the runs; the others show the scatter.
    const double runs = 1.0 + seen.back().run - seen.front().run, others = runs - 2.0;
    const double t = boost::math::quantile(
        boost::math::complement(boost::math::students_t(others), 0.5 * alarm_level / tried));
    answer.learned_from = runs * std::log1p(t * t / others);
  }
  if (causes == 0 && setup.mistake.reset > 0.0) {
    const Eigen::MatrixXd zeros = common_to_runs(seen, one);
    const double zero = setup.mistake.reset * rms_torque(rows);
    const Eigen::MatrixXd rest = covariance - zero * zero * zeros;
    double best = infinity;
    for (const Effect* e : entries)
      best = std::min(best, least_with_scatter(rig, seen, rest, zeros, {.effects = {e}}));
    for (const Datum& d : data_of_the_files())
      best = std::min(best, least_with_scatter(rig, seen, rest, zeros, {.datum = &d}));
    answer.learned_detection = least_with_scatter(rig, seen, rest, zeros, {}) - best;
    answer.learned_from = answer.needed;
  }
  if (causes < 2) {
    answer.lead = wrong_single.cost - true_cost;
    answer.rival = wrong_single.name;
    if (std::isfinite(right_single.cost)) answer.entry_lead = wrong_single.cost - right_single.cost;
    return answer;
  }

  Scored wrong_pair;
  const std::vector<std::string_view> first = rig.accepted(0), second = rig.accepted(1);
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t k = i + 1; k < entries.size(); ++k) {
      const std::string_view a = entries[i]->id, b = entries[k]->id;
      if ((contains(first, a) && contains(second, b)) ||
          (contains(first, b) && contains(second, a)))
        continue;
      wrong_pair.take(likelihood.least({.effects = {entries[i], entries[k]}}),
                      std::string(a) + " + " + std::string(b));
    }
  answer.lead = wrong_pair.cost - true_cost;
  answer.rival = wrong_pair.name;
  answer.least_loss = std::min(likelihood.least({.effects = {truth.effects[0]}}),
                               likelihood.least({.effects = {truth.effects[1]}})) -
                      true_cost;
  return answer;
}

}  // namespace hidden_effect
