#include "fit/evidence.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/free_parameters.h"
#include "fit/quantity.h"
#include "fit/screening.h"
#include "fit/shaft_prediction.h"

namespace raceway::fit {

namespace {

constexpr std::size_t fewest_rows = 15;
constexpr Eigen::Index fewest_freedom = 8;  // of the noise
constexpr double first_relative = 0.02;     // noise assumed before it is known
constexpr double least_noise = 1e-8;        // of the readings: less is rounding of a computer
// Below this share of the rms, errors no longer shrink with the reading. Most of the noise of a
// displacement is that of the sensor whatever it reads.
constexpr double torque_floor = 0.05, displacement_floor = 1.0;

int distinct(const DataSet& data, double relative, double absolute, double (*value)(const Row&)) {
  std::vector<double> values;
  for (const Row& row : data.rows) values.push_back(value(row));
  std::sort(values.begin(), values.end());
  int count = 0;
  double last = unset;
  for (const double v : values)
    if (std::isnan(last) || v - last > relative * std::abs(v) + absolute) {
      ++count;
      last = v;
    }
  return count;
}

void require_enough(const DataSet& data, std::size_t parameters) {
  const std::size_t needed = std::max(fewest_rows, parameters + 12);
  if (data.rows.size() < needed)
    throw std::invalid_argument(fmt::format(
        "{}: {} rows that can be predicted: a verdict needs at least {}, better 60 or more over "
        "several speeds, loads and temperatures",
        data.source, data.rows.size(), needed));
  const int speeds = distinct(data, 5e-3, 0.0, [](const Row& r) { return r.point.speed; });
  const int loads =
      std::max(distinct(data, 5e-3, 0.0, [](const Row& r) { return r.point.axial_load; }),
               distinct(data, 5e-3, 0.0,
                        [](const Row& r) { return std::isnan(r.preload) ? 0.0 : r.preload; }));
  const int temperatures =
      distinct(data, 0.0, 1.0, [](const Row& r) { return r.point.temperature; });
  if (speeds * loads * temperatures < 2)
    throw std::invalid_argument(
        data.source +
        ": all rows stand at one operating point: a verdict needs at least three speeds, better "
        "with several loads and temperatures");
  if (std::max({speeds, loads, temperatures}) < 3)
    throw std::invalid_argument(fmt::format(
        "{}: {} speed(s), {} load(s), {} temperature(s): a verdict needs three levels of at least "
        "one of them",
        data.source, speeds, loads, temperatures));
}

/// What a displacement a thousand times too small or large, or of the other sign, looks like.
std::string unit_or_sign(const std::vector<double>& predicted, const DataSet& data) {
  if (data.quantity != Quantity::axial_displacement) return "";
  double product = 0.0, square = 0.0, readings = 0.0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const double reading = data.rows[i].measured;
    if (!std::isfinite(predicted[i]) || !std::isfinite(reading)) continue;
    product += predicted[i] * reading;
    square += predicted[i] * predicted[i];
    readings += reading * reading;
  }
  const double alike = product / std::sqrt(square * readings), factor = product / square;
  if (alike < -0.7)
    return "the readings run against the model: its layout, or the sign of axial_displacement_um, "
           "which is positive towards the tool?";
  if (alike > 0.7 && (factor < 0.005 || factor > 200.0))
    return fmt::format(
        "the readings are about {:.2g} times what the model says: is axial_displacement_um in um?",
        factor);
  return "";
}

/// Takes the free parameters out that change no reading, near the start nor away from it: what was
/// measured with each row stands in their place, or nothing here depends on them.
std::vector<std::string> take_idle(Problem& problem, const Response& response) {
  // Away from the start all others have moved: a shape shows only where its size is not zero.
  const Eigen::VectorXd start = response.start();
  Eigen::VectorXd moved = start;
  for (std::size_t k = 0; k < response.parameters.size(); ++k) {
    const FitParameter& p = response.parameters[k];
    const auto at = static_cast<Eigen::Index>(k);
    const double step = (0.2 + 0.03 * static_cast<double>(k)) * p.scale;
    moved[at] =
        start[at] + step <= p.upper ? start[at] + step : std::max(start[at] - step, p.lower);
  }
  std::vector<std::string> idle;
  for (std::size_t k = 0; k < response.parameters.size(); ++k) {
    const FitParameter& p = response.parameters[k];
    bool moves = false;
    for (const Eigen::VectorXd& from : {start, moved})
      for (const double step : {0.1, -0.1, 1e-3, -1e-3}) {
        if (moves) break;
        const Eigen::VectorXd there = response.readings(from);
        Eigen::VectorXd x = from;
        const auto at = static_cast<Eigen::Index>(k);
        x[at] = std::clamp(x[at] + step * p.scale, p.lower, p.upper);
        const Eigen::VectorXd change = response.readings(x) - there;
        moves = !(change.norm() <= least_noise * there.norm());  // also where there is no balance
      }
    if (!moves) idle.push_back(p.name);
  }
  std::erase_if(problem.base, [&](const std::string& name) {
    return std::find(idle.begin(), idle.end(), name) != idle.end();
  });
  return idle;
}

/// Noise from what base law, smooth surfaces, levels and all candidates together leave.
NoiseModel noise_of_saturated_regression(const Evidence& evidence,
                                         const Eigen::VectorXd& base_values,
                                         const NoiseOptions& options) {
  const Problem& problem = evidence.problem;
  const auto rows = static_cast<Eigen::Index>(problem.data.rows.size());
  // In proportion to the reading.
  const Eigen::VectorXd inverse = evidence.size.cwiseInverse();
  // With the base model itself, which its own derivatives need not hold.
  Eigen::MatrixXd base = evidence.response.jacobian(base_values);
  base.conservativeResize(rows, base.cols() + 1);
  base.rightCols(1) = evidence.response.at(base_values);
  base.applyOnTheLeft(inverse.asDiagonal());
  const Eigen::MatrixXd levels = inverse.asDiagonal() * level_columns(problem.data, evidence.size);
  std::vector<Eigen::MatrixXd> blocks{
      base, inverse.asDiagonal() * surface_columns(problem.data, evidence.size)};
  std::vector<double> tolerance{1e-6, 1e-3};
  Eigen::Index count = 0;
  for (const Candidate& c : problem.candidates)
    count += c.not_testable.empty() ? c.most.cols() + c.scores.cols() : 0;
  Eigen::MatrixXd scores(rows, count);
  count = 0;
  for (const Candidate& c : problem.candidates) {
    if (!c.not_testable.empty()) continue;
    for (const Eigen::MatrixXd* columns : {&c.most, &c.scores}) {
      scores.middleCols(count, columns->cols()) = inverse.asDiagonal() * *columns;
      count += columns->cols();
    }
  }
  // Few rows do not hold all columns. A displacement at many speeds bends where a candidate does,
  // a torque may do so at any level.
  const bool levels_first = problem.data.quantity == Quantity::friction_torque;
  blocks.push_back(levels_first ? levels : scores);
  tolerance.push_back(levels_first ? 1e-2 : invisible);
  blocks.push_back(levels_first ? scores : levels);
  tolerance.push_back(levels_first ? invisible : 1e-2);
  const Eigen::MatrixXd saturated =
      independent_columns(blocks, tolerance, std::min(rows / 2, rows - fewest_freedom));
  return estimate_noise_model(problem.data, evidence.size.asDiagonal() * saturated, evidence.size,
                              options);
}

}  // namespace

Evidence gather_evidence(const Model& model, const DataSet& data,
                         std::span<const effects::Description* const> candidates, int most_rows,
                         const NoiseOptions& options) {
  require_measured_subject(model, data);
  const QuantityText quantity = text_of(data.quantity);
  Evidence evidence{.problem = {.model = model}};
  Problem& problem = evidence.problem;
  for (const ModelParameter& p : free_parameters(model)) problem.base.push_back(p.name);
  problem.data = data;
  problem.data.rows.clear();
  evidence.rows_in_file = static_cast<int>(data.rows.size());
  DataSet sorted = data;
  sort_rows(sorted);
  const std::size_t every =
      std::max<std::size_t>(1, (sorted.rows.size() + static_cast<std::size_t>(most_rows) - 1) /
                                   static_cast<std::size_t>(most_rows));
  DataSet thinned = data;
  thinned.rows.clear();
  for (std::size_t i = every / 2; i < sorted.rows.size(); i += every)
    thinned.rows.push_back(sorted.rows[i]);
  const std::vector<double> predicted = predict_readings(model, thinned);
  evidence.hint = unit_or_sign(predicted, thinned);
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    if (std::isfinite(predicted[i]) && std::isfinite(thinned.rows[i].measured))
      problem.data.rows.push_back(thinned.rows[i]);
    else
      problem.rows_not_predicted.push_back(thinned.rows[i].line);
  }
  require_enough(problem.data, problem.base.size());
  const auto rows = static_cast<Eigen::Index>(problem.data.rows.size());
  problem.measured.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    problem.measured[i] = problem.data.rows[static_cast<std::size_t>(i)].measured;
  problem.candidates = make_candidates(model, candidates);
  if (std::any_of(problem.candidates.begin(), problem.candidates.end(),
                  [](const Candidate& c) { return c.description->needs_equilibrium; }))
    problem.balances = entered_balances(model, problem.data);

  // A first fit with the noise that rigs have, for a smooth size of each reading.
  evidence.response = response_with(problem, {});
  evidence.idle = take_idle(problem, evidence.response);
  if (!evidence.idle.empty()) evidence.response = response_with(problem, {});
  evidence.response.find_affine_form();
  const double rms = problem.measured.norm() / std::sqrt(static_cast<double>(rows));
  if (!(rms > 0.0)) throw std::invalid_argument(data.source + ": all readings are zero");
  if (problem.measured.maxCoeff() - problem.measured.minCoeff() <= least_noise * rms)
    throw std::invalid_argument(
        fmt::format("{}: all readings are {:.4g} {}: a verdict needs readings that vary",
                    data.source, problem.measured[0] / quantity.factor, quantity.unit));
  const double floor =
      data.quantity == Quantity::friction_torque ? torque_floor : displacement_floor;
  const Eigen::VectorXd guess =
      first_relative * problem.measured.cwiseAbs().cwiseMax(2.0 * floor * rms);
  const auto starts_of = [&](const Eigen::VectorXd& x) {
    return std::vector<Eigen::VectorXd>{x, 0.8 * x, 1.25 * x, 0.5 * x};
  };
  const ResponseFit first = fit_response(evidence.response, Whitening(guess, {}, 0.0, 0.0),
                                         problem.measured, starts_of(evidence.response.start()));
  if (!first.converged)
    throw std::invalid_argument(
        data.source + ": the fit of the model's own parameters does not converge; " +
        (evidence.hint.empty() ? "free fewer of them, or check units of model and data"
                               : evidence.hint));
  evidence.size = first.prediction.cwiseAbs().cwiseMax(floor * rms);
  screen_candidates(problem, first.values);

  evidence.noise = problem.data.noise == NoiseSource::regression
                       ? known_noise_model(problem.data)
                       : noise_of_saturated_regression(evidence, first.values, options);
  if (!(evidence.noise.whitening.std().minCoeff() > least_noise * rms) ||
      !evidence.noise.whitening.std().allFinite())
    throw std::invalid_argument(
        data.source +
        fmt::format(": the readings have no scatter at all, so nothing can be held against it; "
                    "give std_{} where they are exact",
                    quantity.key_unit));
  evidence.base = fit_response(evidence.response, evidence.noise.whitening, problem.measured,
                               starts_of(first.values));
  if (!evidence.base.converged)
    throw std::invalid_argument(data.source +
                                ": the fit of the model's own parameters does not converge");
  return evidence;
}

}  // namespace raceway::fit
