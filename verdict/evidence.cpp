#include "verdict/evidence.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/distributions.h"
#include "fit/smooth_columns.h"
#include "fit/subspace.h"
#include "fit/thinned.h"
#include "record/levels.h"
#include "verdict/gate.h"

namespace raceway::verdict {

namespace {

constexpr std::size_t fewest_rows = 15;          // to estimate their noise
constexpr std::size_t fewest_declared_rows = 8;  // each with a standard deviation
constexpr Eigen::Index fewest_freedom = 8;       // of the noise
constexpr double first_relative = 0.02;          // noise assumed before it is known
constexpr double least_noise = 1e-8;             // of the readings: less is rounding of a computer
constexpr double known_degrees = 1000.0;         // from which on the noise is as good as known
constexpr double contradicted_by_misfit = 0.01;  // p

/// How many values of a setting can be told apart.
int distinct(const record::Channel& channel, std::span<const double> column) {
  std::vector<double> values(column.begin(), column.end());
  std::sort(values.begin(), values.end());
  int count = 0;
  double last = unset;
  for (const double v : values) {
    const double width = channel.ratio ? channel.step * std::abs(v) : 2.0 * channel.step;
    if (std::isnan(v) || (count > 0 && !(v - last > width))) continue;
    ++count;
    last = v;
  }
  return count;
}

/// Throws unless some setting has three levels.
void require_levels(const record::Record& record) {
  int combinations = 1, most = 0;
  std::vector<std::string> found;
  for (const record::Column& c : record.columns) {
    if (c.channel->role != record::Role::setting) continue;
    const int levels = distinct(*c.channel, c.values);
    if (levels == 0) continue;
    combinations *= std::min(levels, 3);
    most = std::max(most, levels);
    found.push_back(fmt::format("{} {}{}", levels, c.channel->words, levels == 1 ? "" : "s"));
  }
  if (found.empty()) return;
  if (combinations < 2)
    throw std::invalid_argument(record.source +
                                ": all rows are at one operating point: a verdict needs at least "
                                "three levels of one setting, better of several settings");
  if (most < 3)
    throw std::invalid_argument(
        fmt::format("{}: {}: a verdict needs three levels of at least one setting", record.source,
                    fmt::join(found, ", ")));
}

/// Every reading comes with its standard deviation.
bool deviations_declared(const fit::Problem& problem) {
  const fit::Observations& observed = problem.observed;
  for (std::size_t c = 0; c < observed.channels.size(); ++c)
    if (fit::readings_of(*problem.record, observed, c).std.size() == 0) return false;
  return true;
}

std::size_t rows_for_noise(const fit::Problem& problem) {
  return std::max(fewest_rows, problem.base.size() + 12);
}

/// True where rows are too few to tell their noise, which their declared deviations then are.
/// Throws where these are missing, or rows are too few even so.
bool require_rows(const fit::Problem& problem) {
  const std::size_t rows = problem.observed.row.size();
  const std::size_t needed = rows_for_noise(problem);
  if (rows >= needed) return false;
  const std::size_t declared = std::max(fewest_declared_rows, problem.base.size() + 4);
  if (rows >= declared && deviations_declared(problem)) return true;
  throw std::invalid_argument(fmt::format(
      "{}: {} rows can be predicted. A verdict needs at least {}, better 60 or more over several "
      "levels of every setting; or at least {} if each row has its standard deviation (std_{})",
      problem.record->source, rows, needed, declared,
      problem.observed.channels.front().channel->key_unit()));
}

/// Why nothing can be learnt of these readings; empty if something can.
std::string no_use(const record::Channel& channel, const Eigen::VectorXd& readings,
                   std::size_t needed) {
  if (readings.size() == 0) return fmt::format("no reading of {}", channel.words);
  if (static_cast<std::size_t>(readings.size()) < needed)
    return fmt::format("{} readings of {} are too few; at least {} are needed", readings.size(),
                       channel.words, needed);
  const double size = fit::rms(readings);
  if (!(size > 0.0)) return "all readings are zero";
  if (readings.maxCoeff() - readings.minCoeff() > least_noise * size) return {};
  return fmt::format("all readings are {:.4g} {}: a verdict needs readings that vary",
                     channel.in_unit(readings[0]), channel.unit);
}

/// Channels of which nothing can be learnt are left out, and named, where there are others.
void require_variation(Evidence& evidence) {
  fit::Observations& observed = evidence.problem.observed;
  const std::size_t needed = evidence.few_rows ? fewest_declared_rows : fewest_rows;
  std::vector<std::size_t> useful;
  std::string first;
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    const record::Channel& channel = *observed.channels[c].channel;
    const std::string wrong = no_use(channel, observed.of(c, observed.measured), needed);
    if (wrong.empty()) {
      useful.push_back(c);
      continue;
    }
    if (first.empty()) first = wrong;
    evidence.notes.push_back(
        record::note::rows_used(fmt::format("{} is not used: {}", channel.name, wrong),
                                {.key = std::string(channel.name)}));
  }
  if (useful.empty()) throw std::invalid_argument(evidence.problem.record->source + ": " + first);
  if (useful.size() < observed.channels.size()) observed = observed.only(useful);
}

/// Takes the free parameters out that change no reading, near the start nor away from it: what was
/// measured with each row stands in their place, or nothing here depends on them.
std::vector<std::string> take_idle(fit::Problem& problem, const fit::Response& response) {
  // Away from the start all others have moved: a shape shows only where its size is not zero.
  const Eigen::VectorXd start = response.start();
  Eigen::VectorXd moved = start;
  for (std::size_t k = 0; k < response.parameters.size(); ++k) {
    const record::Parameter& p = response.parameters[k];
    const auto at = static_cast<Eigen::Index>(k);
    const double step = (0.2 + 0.03 * static_cast<double>(k)) * p.scale;
    moved[at] =
        start[at] + step <= p.upper ? start[at] + step : std::max(start[at] - step, p.lower);
  }
  std::vector<std::string> idle;
  for (std::size_t k = 0; k < response.parameters.size(); ++k) {
    const record::Parameter& p = response.parameters[k];
    bool moves = false;
    for (const Eigen::VectorXd& from : {start, moved})
      for (const double step : {0.1, -0.1, 1e-3, -1e-3}) {
        if (moves) break;
        const Eigen::VectorXd there = response.readings(from);
        Eigen::VectorXd x = from;
        const auto at = static_cast<Eigen::Index>(k);
        x[at] = std::clamp(x[at] + step * p.scale, p.lower, p.upper);
        const Eigen::VectorXd change = response.readings(x) - there;
        moves = !(change.norm() <= least_noise * there.norm());  // also without a prediction
      }
    if (!moves) idle.push_back(p.name);
  }
  std::erase_if(problem.base, [&](const std::string& name) {
    return std::find(idle.begin(), idle.end(), name) != idle.end();
  });
  return idle;
}

/// The rows of a record that are used, those that can be predicted among them, and what was read.
void take_rows(const record::Record& record, int most_rows, Evidence& evidence) {
  fit::Problem& problem = evidence.problem;
  const fit::Subject& subject = *problem.subject;
  evidence.rows_in_record = record.rows();
  std::vector<std::size_t> order = fit::order_of_rows(record);
  if (subject.has_memory()) {
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  } else {
    order = fit::thinned(std::move(order), static_cast<std::size_t>(most_rows));
  }
  const std::vector<fit::Measured> channels = subject.measured();
  const record::Record sorted = record.picked(order);
  const std::vector<double> predicted = fit::predict(subject, sorted);
  evidence.hint = subject.doubt(sorted, predicted);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < order.size(); ++i) {
    bool any = subject.has_memory();
    for (std::size_t c = 0; c < channels.size(); ++c)
      any = any || (std::isfinite(predicted[c * order.size() + i]) &&
                    std::isfinite(sorted.value(*channels[c].channel, i)));
    if (any) {
      kept.push_back(i);
      problem.rows.push_back(order[i]);
    } else {
      problem.not_predicted.push_back(order[i]);
    }
  }
  std::vector<double> predicted_kept;
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (const std::size_t i : kept) predicted_kept.push_back(predicted[c * order.size() + i]);
  std::sort(problem.not_predicted.begin(), problem.not_predicted.end());
  problem.record = std::make_shared<const record::Record>(sorted.picked(kept));
  problem.observed = fit::observe(channels, *problem.record, predicted_kept);
}

std::vector<Eigen::VectorXd> starts_of(const Eigen::VectorXd& x) {
  return {x, 0.8 * x, 1.25 * x, 0.5 * x};
}

/// Change of the readings as the inputs that scatter change by the width of a level each, root of
/// the sum of squares; empty where none does.
Eigen::VectorXd input_slope(const fit::Problem& problem, const fit::Response& response,
                            const Eigen::VectorXd& base_values) {
  Eigen::ArrayXd square;
  for (const record::Channel* channel : problem.subject->scattering(*problem.record)) {
    auto moved = std::make_shared<record::Record>(*problem.record);
    std::vector<double> values(problem.record->values(*channel).begin(),
                               problem.record->values(*channel).end());
    const double step = record::step_of(*channel, values);
    for (double& v : values) v += step;
    moved->set(*channel, std::move(values));
    const Eigen::VectorXd change =
        fit::response_with(problem, {}, moved, problem.observed).readings(base_values) -
        response.readings(base_values);
    if (!change.allFinite()) continue;
    if (square.size() == 0) square = Eigen::ArrayXd::Zero(change.size());
    square += change.array().square();
  }
  return square.sqrt().matrix();
}

/// Noise from what base law, smooth surfaces, levels and all candidates together leave, channel by
/// channel.
std::vector<fit::NoiseModel> noise_of_saturated_regression(const Evidence& evidence,
                                                           const Eigen::VectorXd& base_values,
                                                           const fit::NoiseOptions& options) {
  const fit::Problem& problem = evidence.problem;
  const fit::Observations& observed = problem.observed;
  const Eigen::Index count = observed.size();
  // With the base model itself, which its own derivatives need not hold.
  Eigen::MatrixXd base = evidence.response.jacobian(base_values);
  base.conservativeResize(count, base.cols() + 1);
  base.rightCols(1) = evidence.response.at(base_values);
  Eigen::Index columns = 0;
  for (const fit::Screened& s : problem.candidates)
    columns += s.not_testable.empty() ? s.most.cols() + s.scores.cols() : 0;
  Eigen::MatrixXd scores(count, columns);
  columns = 0;
  for (const fit::Screened& s : problem.candidates) {
    if (!s.not_testable.empty()) continue;
    for (const Eigen::MatrixXd* part : {&s.most, &s.scores}) {
      scores.middleCols(columns, part->cols()) = *part;
      columns += part->cols();
    }
  }
  const Eigen::MatrixXd surface =
      fit::surface_columns(evidence.saturation.surface, observed, evidence.size);
  const Eigen::MatrixXd levels =
      fit::level_columns(evidence.saturation.levels, *problem.record, observed, evidence.size);
  const Eigen::VectorXd slope = input_slope(problem, evidence.response, base_values);
  std::vector<fit::NoiseModel> noise;
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    fit::ChannelReadings readings = fit::readings_of(*problem.record, observed, c);
    if (slope.size() > 0) readings.slope = observed.of(c, slope);
    if (readings.known || evidence.few_rows) {
      noise.push_back(fit::known_noise_model(readings));
      fit::add_model_error(noise.back(), readings, observed.channels[c].model_error);
      continue;
    }
    const Eigen::VectorXd size = observed.of(c, evidence.size);
    // In proportion to the reading.
    const auto part = [&](const Eigen::MatrixXd& all) {
      return Eigen::MatrixXd(size.cwiseInverse().asDiagonal() *
                             all.middleRows(observed.first[c], observed.size(c)));
    };
    std::vector<Eigen::MatrixXd> blocks{part(base), part(surface), part(levels), part(scores)};
    std::vector<double> tolerance{1e-6, 1e-3, 1e-2, invisible};
    if (!evidence.saturation.levels_before_candidates) {
      std::swap(blocks[2], blocks[3]);
      std::swap(tolerance[2], tolerance[3]);
    }
    // What pieces of one dwell have in common must be left to the noise.
    const std::vector<bool>& starts = readings.order.new_state;
    const Eigen::Index rows =
        readings.order.has_states ? std::count(starts.begin(), starts.end(), true) : size.size();
    const Eigen::MatrixXd saturated = fit::independent_columns(
        blocks, tolerance, std::max<Eigen::Index>(0, std::min(rows / 2, rows - fewest_freedom)));
    noise.push_back(
        fit::estimate_noise_model(readings, size.asDiagonal() * saturated, size, options));
    fit::add_model_error(noise.back(), readings, observed.channels[c].model_error);
  }
  return noise;
}

/// Noise that is not there cannot be held against anything.
void require_scatter(const Evidence& evidence) {
  const fit::Observations& observed = evidence.problem.observed;
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    const Eigen::VectorXd& std = evidence.noise[c].whitening.std();
    if (std.minCoeff() > least_noise * fit::rms(observed.of(c, observed.measured)) &&
        std.allFinite())
      continue;
    const record::Channel& channel = *observed.channels[c].channel;
    throw std::invalid_argument(
        fmt::format("{}: the readings have no scatter, so the program cannot judge a misfit. If "
                    "they are exact, enter std_{}",
                    evidence.problem.record->source, channel.key_unit()));
  }
}

/// Few rows hold one number of a candidate, not a shape beside it.
void leave_out_shapes(Evidence& evidence) {
  for (fit::Screened& s : evidence.problem.candidates)
    if (s.candidate.parameters.size() > 1)
      s.not_testable = fmt::format(
          "the data have too few rows to fit the {} parameters of this effect; at least {} rows "
          "are needed",
          s.candidate.parameters.size(), rows_for_noise(evidence.problem));
  evidence.notes.push_back(record::note::noise(
      fmt::format("{} rows are too few to estimate the noise: diagnose uses the declared standard "
                  "deviations, and tests only single effects with one parameter",
                  evidence.problem.observed.row.size())));
}

/// Rows, candidates and the response of the model, before anything is fitted.
Evidence look_at(const fit::Subject& subject, const record::Record& record,
                 const EvidenceOptions& options) {
  Evidence evidence;
  fit::Problem& problem = evidence.problem;
  if (auto informed = subject.informed_by(record))
    problem.subject = std::move(informed);
  else
    problem.subject = subject.with_values({});
  for (const record::Parameter& p : fit::find_parameters(subject, subject.free()))
    problem.base.push_back(p.name);
  take_rows(record, options.most_rows, evidence);
  evidence.few_rows = require_rows(problem);
  if (!subject.has_memory()) require_levels(*problem.record);
  require_variation(evidence);
  problem.prepared = subject.prepare(*problem.record);
  problem.cancelled = options.cancelled;
  problem.candidates = fit::make_candidates(subject, options.candidates);
  if (evidence.few_rows) leave_out_shapes(evidence);
  evidence.saturation = subject.saturation(*problem.record);
  evidence.response = fit::response_with(problem, {});
  evidence.idle = take_idle(problem, evidence.response);
  if (!evidence.idle.empty()) evidence.response = fit::response_with(problem, {});
  evidence.response.find_affine_form();
  return evidence;
}

/// Values of the base with the noise that most rigs have, for a smooth size of each reading.
Eigen::VectorXd first_values(Evidence& evidence) {
  const fit::Problem& problem = evidence.problem;
  const fit::Observations& observed = problem.observed;
  const Eigen::VectorXd guess = first_relative * fit::floored(observed, observed.measured, 2.0);
  const fit::ResponseFit first =
      fit::fit_response(evidence.response, fit::Whitening(guess, {}, 0.0, 0.0), observed.measured,
                        starts_of(evidence.response.start()));
  if (!first.converged)
    throw std::invalid_argument(
        problem.record->source + ": the fit of the model's own parameters does not converge; " +
        (evidence.hint.empty()
             ? "fit fewer parameters ([calibration] free), or check the units of model and data"
             : evidence.hint));
  evidence.size = fit::floored(observed, first.prediction, 1.0);
  return first.values;
}

/// The noise as it is found without what the model is still to learn from this record, which then
/// is one candidate among others: so an effect has one size, whether it is diagnosed, added or
/// calibrated. Nothing where the model has no such effect, or without it uses other rows.
std::vector<fit::NoiseModel> noise_without_free_candidates(const fit::Subject& subject,
                                                           const record::Record& record,
                                                           EvidenceOptions options,
                                                           const fit::Problem& problem) {
  const auto bare = subject.without_free_candidates();
  if (!bare) return {};
  if (!options.candidates.empty()) {
    const std::vector<fit::Candidate> known = subject.candidates();
    for (const fit::Candidate& c : bare->candidates())
      if (std::none_of(known.begin(), known.end(), [&](const auto& k) { return k.id == c.id; }))
        options.candidates.push_back(c.id);
  }
  try {
    Evidence evidence = look_at(*bare, record, options);
    if (evidence.problem.rows != problem.rows ||
        evidence.problem.observed.row != problem.observed.row)
      return {};
    const Eigen::VectorXd values = first_values(evidence);
    fit::screen_candidates(evidence.problem, evidence.saturation, values);
    return noise_of_saturated_regression(evidence, values, options.noise);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

void fit_base(Evidence& evidence, const Eigen::VectorXd& start) {
  const fit::Problem& problem = evidence.problem;
  std::vector<fit::Whitening> parts;
  evidence.degrees_of_freedom = 0.0;
  for (const fit::NoiseModel& noise : evidence.noise) {
    parts.push_back(noise.whitening);
    evidence.degrees_of_freedom += noise.degrees_of_freedom;
  }
  const auto together = [](const std::vector<fit::Whitening>& of) {
    return of.size() == 1 ? of.front() : fit::Whitening(of);
  };
  evidence.whitening = together(parts);
  evidence.allowed.clear();
  for (std::size_t c = 0; c < parts.size(); ++c)
    for (const fit::Whitening& other : evidence.noise[c].allowed) {
      std::vector<fit::Whitening> changed = parts;
      changed[c] = other;
      evidence.allowed.push_back(together(changed));
    }
  evidence.base = fit::fit_response(evidence.response, evidence.whitening,
                                    problem.observed.measured, starts_of(start));
  if (!evidence.base.converged)
    throw std::invalid_argument(
        problem.record->source +
        ": the fit of the model's own parameters does not converge; fit fewer parameters "
        "([calibration] free), or check the units of model and data");
}

/// The noise of one channel held against what the refitted model leaves of it, and against repeats.
///
/// A model may not come nearer to its readings than noise lets it: what the saturated regression
/// has on top of it then explains less than chance would, and the noise was overrated: it is scaled
/// down to what is left. Where rows as they stand are nearer than their noise, it may have no
/// memory; where repeats scatter more than it, theirs is allowed as well. True where anything is
/// another.
bool estimate_again(const Evidence& evidence, std::size_t channel, fit::NoiseModel& noise,
                    std::vector<record::Note>& notes) {
  const fit::Observations& observed = evidence.problem.observed;
  if (noise.degrees_of_freedom >= known_degrees || noise.as_declared) return false;
  const std::size_t allowed = noise.allowed.size();
  const Eigen::VectorXd rest =
      observed.of(channel, Eigen::VectorXd(observed.measured - evidence.base.prediction));
  const double left = static_cast<double>(rest.size() - evidence.base.tangent.cols());
  const double more = left - noise.degrees_of_freedom;
  const double misfit = noise.whitening(rest).squaredNorm();
  const double share = std::max(0.0, misfit - noise.degrees_of_freedom) / std::max(more, 1.0);
  const bool overrated = more >= 1.0 && 1.0 - fit::f_above(more, noise.degrees_of_freedom, share) <
                                            contradicted_by_misfit;
  if (overrated) {
    const double factor = std::sqrt(misfit / left);
    noise.scale(factor);
    noise.degrees_of_freedom = left;
    notes.push_back(
        record::note::noise(fmt::format("the misfit of {} is smaller than the estimated noise, so "
                                        "the program multiplies this estimate by {:.2g}",
                                        observed.channels[channel].channel->words, factor)));
  }
  const double plain = rest.cwiseQuotient(noise.whitening.std()).squaredNorm() / left;
  if (noise.has_memory() && plain < 1.0)
    noise.allowed.emplace_back(Eigen::VectorXd(std::sqrt(plain) * noise.whitening.std()),
                               fit::RowOrder{}, 0.0, 0.0);
  if (noise.repeats_p_value < contradicted_by_misfit && noise.repeats_statistic > 1.0)
    noise.allowed.push_back(noise.whitening.scaled(std::sqrt(noise.repeats_statistic)));
  return overrated || noise.allowed.size() > allowed;
}

}  // namespace

Evidence gather_evidence(const fit::Subject& subject, const record::Record& record,
                         const EvidenceOptions& given) {
  EvidenceOptions options = given;
  options.noise.alternatives = options.noise.alternatives && options.screened;
  subject.require(record);
  Evidence evidence = look_at(subject, record, options);
  const Eigen::VectorXd values = first_values(evidence);
  evidence.noise = noise_without_free_candidates(subject, record, options, evidence.problem);
  if (options.screened || evidence.noise.empty())
    fit::screen_candidates(evidence.problem, evidence.saturation, values);
  if (evidence.noise.empty())
    evidence.noise = noise_of_saturated_regression(evidence, values, options.noise);
  require_scatter(evidence);
  fit_base(evidence, values);
  bool again = false;
  for (std::size_t c = 0; c < evidence.noise.size(); ++c)
    again = estimate_again(evidence, c, evidence.noise[c], evidence.notes) || again;
  if (again) fit_base(evidence, evidence.base.values);
  return evidence;
}

}  // namespace raceway::verdict
