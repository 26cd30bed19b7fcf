#include "verdict/detail/weighed.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace raceway::verdict {

namespace {

/// All rows of a record that can be predicted, without candidates.
fit::Problem plain_problem(const fit::Subject& subject, const record::Record& record) {
  fit::Problem problem;
  problem.subject = subject.with_values({});
  std::vector<std::size_t> order = fit::order_of_rows(record);
  if (subject.has_memory())
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  problem.record = std::make_shared<const record::Record>(record.picked(order));
  problem.rows = std::move(order);
  problem.prepared = subject.prepare(*problem.record);
  const std::vector<double> predicted = fit::predict(subject, *problem.record);
  problem.observed = fit::observe(subject.measured(), *problem.record, predicted);
  std::vector<std::size_t> read;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c)
    if (problem.observed.size(c) > 0) read.push_back(c);
  if (read.size() < problem.observed.channels.size())
    problem.observed = problem.observed.only(read);
  const std::vector<fit::Measured>& channels = problem.observed.channels;
  for (std::size_t i = 0; i < problem.rows.size(); ++i)
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (std::isfinite(problem.record->value(*channels[c].channel, i)) &&
          !std::isfinite(predicted[problem.observed.place[c] * problem.rows.size() + i]))
        problem.not_predicted.push_back(problem.rows[i]);
  std::sort(problem.not_predicted.begin(), problem.not_predicted.end());
  return problem;
}

/// Where the data cannot tell their noise: declared deviations, or all readings of a channel alike.
void weigh_plainly(Weighed& weighed, std::vector<record::Note>& messages) {
  const fit::Problem& problem = weighed.problem;
  std::vector<fit::Whitening> parts;
  weighed.noise_known = true;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c) {
    const fit::ChannelReadings readings = fit::readings_of(*problem.record, problem.observed, c);
    if (readings.std.size() > 0) {
      parts.emplace_back(readings.std, fit::RowOrder{}, 0.0, 0.0);
      continue;
    }
    weighed.noise_known = false;
    if (const record::Column* const some =
            problem.record->deviation_of(*problem.observed.channels[c].channel);
        some &&
        std::any_of(some->values.begin(), some->values.end(), [](double s) { return s > 0.0; }))
      messages.push_back(record::note::noise(
          "not every row has a standard deviation: all rows have the same weight"));
    const double size = readings.measured.size() > 0 ? fit::rms(readings.measured) : 1.0;
    parts.emplace_back(Eigen::VectorXd::Constant(readings.measured.size(), size > 0.0 ? size : 1.0),
                       fit::RowOrder{}, 0.0, 0.0);
  }
  weighed.whitening = fit::Whitening(parts);
  weighed.as_declared = weighed.noise_known;
}

/// The noise that a thinned record has shown, on all of its rows.
void weigh_as(const Evidence& evidence, const fit::Response& response, Weighed& weighed) {
  const fit::Problem& problem = weighed.problem;
  const Eigen::VectorXd size =
      fit::floored(weighed.problem.observed, response.readings(evidence.base.values), 1.0);
  std::vector<fit::Whitening> parts;
  for (std::size_t c = 0; c < problem.observed.channels.size(); ++c)
    parts.push_back(fit::whitening_of(evidence.noise[c],
                                      fit::readings_of(*problem.record, problem.observed, c),
                                      problem.observed.of(c, size)));
  weighed.whitening = fit::Whitening(parts);
  weighed.noise_known = true;
}

}  // namespace

std::optional<Evidence> evidence_of(const fit::Subject& subject, const record::Record& record) {
  try {
    return gather_evidence(subject, record, {.screened = false});
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Weighed weigh(const fit::Subject& subject, const record::Record& record,
              const std::optional<Evidence>& evidence, std::vector<record::Note>& messages) {
  if (evidence && evidence->rows() + evidence->problem.not_predicted.size() == record.rows())
    return {evidence->problem, evidence->whitening, true};
  Weighed weighed{.problem = plain_problem(subject, record)};
  if (evidence && evidence->noise.size() == weighed.problem.observed.channels.size())
    weigh_as(*evidence,
             fit::response_of(subject, weighed.problem.record, weighed.problem.observed,
                              evidence->problem.base, weighed.problem.prepared),
             weighed);
  else
    weigh_plainly(weighed, messages);
  return weighed;
}

}  // namespace raceway::verdict
