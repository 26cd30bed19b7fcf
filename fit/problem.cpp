#include "fit/problem.h"

#include <algorithm>
#include <cmath>

namespace raceway::fit {

namespace {

constexpr double score_step = 1e-3;    // of the typical size of a candidate
constexpr double no_change = 1e-9;     // of the largest reading
constexpr double unknown_share = 0.1;  // of the readings: the scale where no size is known

std::vector<std::string> names_of(const std::vector<std::string>& base,
                                  std::span<const Screened* const> on) {
  std::vector<std::string> names = base;
  for (const Screened* s : on)
    for (const Parameter& p : s->candidate.parameters) names.push_back(p.name);
  return names;
}

std::vector<std::string> ids_of(std::span<const Screened* const> on) {
  std::vector<std::string> ids;
  for (const Screened* s : on) ids.push_back(s->id());
  return ids;
}

std::string needing(const std::string& words) { return "needs " + words; }

/// Empty where it can be tested, as far as one knows without predictions.
std::string why_not_testable(const Subject& subject, const std::string& id, const Record& record) {
  if (std::string reason = subject.rules_out(id); !reason.empty()) return reason;
  const std::string words = subject.lacks(id, record);
  return words.empty() ? words : needing(words);
}

/// The response of one candidate and where its numbers stand, as it is screened.
class Screening {
 public:
  Screening(const Problem& problem, const Eigen::VectorXd& base_values,
            const Eigen::VectorXd& without, Screened& screened)
      : screened_(screened),
        candidate_(screened.candidate),
        without_(without),
        bases_(static_cast<Eigen::Index>(problem.base.size())) {
    const Screened* const one[] = {&screened};
    response_ = response_with(problem, one);
    neutral_ = response_.start();
    neutral_.head(bases_) = base_values;
    for (std::size_t k = 0; k < candidate_.parameters.size(); ++k)
      if (!std::isnan(candidate_.parameters[k].neutral))
        neutral_[at(k)] = candidate_.parameters[k].neutral;
  }

  void find_scores() {
    const std::vector<Eigen::VectorXd> points = shapes();
    if (candidate_.of_the_user) guess_size();
    screened_.scores.resize(without_.size(), static_cast<Eigen::Index>(points.size()));
    Eigen::Index count = 0;
    for (Eigen::VectorXd point : points) {
      point[at(candidate_.size)] += score_step * screened_.unit_size;
      const Eigen::VectorXd column = (response_.readings(point) - without_) / score_step;
      if (!column.allFinite()) {
        screened_.not_testable =
            "the model with this effect does not give a prediction for every reading";
        break;
      }
      if (column.cwiseAbs().maxCoeff() > no_change * without_.cwiseAbs().maxCoeff())
        screened_.scores.col(count++) = column;
    }
    screened_.scores.conservativeResize(Eigen::NoChange, count);
    if (count == 0 && screened_.not_testable.empty()) score_by_most();
  }

  /// What the most that is met in practice changes.
  void find_most() {
    const Eigen::VectorXd change = response_.readings(most()) - without_;
    if (change.allFinite()) screened_.most = change;
  }

 private:
  /// The neutral point with the largest size that is met.
  [[nodiscard]] Eigen::VectorXd most() const {
    const Parameter& p = screened_.size();
    Eigen::VectorXd x = neutral_;
    x[at(candidate_.size)] = std::clamp(
        screened_.unit_size > 0.0 ? p.plausible_upper : p.plausible_lower, p.lower, p.upper);
    return x;
  }

  /// A small size may change nothing where a large one does, as one below a threshold.
  void score_by_most() {
    const Eigen::VectorXd x = most();
    const double units =
        (x[at(candidate_.size)] - neutral_[at(candidate_.size)]) / screened_.unit_size;
    const Eigen::VectorXd column = (response_.readings(x) - without_) / units;
    if (!column.allFinite() ||
        !(column.cwiseAbs().maxCoeff() > no_change * without_.cwiseAbs().maxCoeff()))
      return;
    screened_.scores = column;
  }

  [[nodiscard]] Eigen::Index at(std::size_t parameter) const {
    return bases_ + static_cast<Eigen::Index>(parameter);
  }

  /// The neutral point with each shape at its start and towards both bounds.
  [[nodiscard]] std::vector<Eigen::VectorXd> shapes() const {
    std::vector<Eigen::VectorXd> points{neutral_};
    for (std::size_t k = 0; k < candidate_.parameters.size(); ++k) {
      const Parameter& p = candidate_.parameters[k];
      if (!std::isnan(p.neutral)) continue;
      for (const double part : {0.1, 0.9}) {
        Eigen::VectorXd x = neutral_;
        x[at(k)] = p.lower + part * (p.upper - p.lower);
        if (x.allFinite()) points.push_back(x);
      }
    }
    return points;
  }

  /// Nothing is known of the size of what a user wrote: a tenth of the readings is its scale.
  void guess_size() {
    Eigen::VectorXd x = neutral_;
    x[at(candidate_.size)] += screened_.unit_size;
    const double change = (response_.readings(x) - without_).norm() / std::abs(screened_.unit_size);
    if (!std::isfinite(change) || !(change > 0.0)) return;
    screened_.unit_size *=
        unknown_share * without_.norm() / (change * std::abs(screened_.unit_size));
    candidate_.parameters[candidate_.size].scale = std::abs(screened_.unit_size);
  }

  Screened& screened_;
  Candidate& candidate_;
  const Eigen::VectorXd& without_;
  Eigen::Index bases_;
  Response response_;
  Eigen::VectorXd neutral_;
};

}  // namespace

std::vector<Screened> make_candidates(const Subject& subject, std::span<const std::string> ids) {
  std::vector<Screened> list;
  for (Candidate& candidate : subject.candidates()) {
    if (!ids.empty() && std::find(ids.begin(), ids.end(), candidate.id) == ids.end()) continue;
    const Parameter& p = candidate.parameters[candidate.size];
    const bool only_below = p.upper <= p.neutral + 1e-9 * p.scale;
    Screened screened{.one_sided = only_below || p.lower >= p.neutral - 1e-9 * p.scale,
                      .unit_size = only_below ? -p.scale : p.scale};
    screened.candidate = std::move(candidate);
    list.push_back(std::move(screened));
  }
  std::sort(list.begin(), list.end(),
            [](const Screened& a, const Screened& b) { return a.id() < b.id(); });
  return list;
}

namespace {

Response cancellable(const Problem& problem, Response response) {
  if (problem.cancelled)
    response.readings = [cancelled = problem.cancelled,
                         readings = std::move(response.readings)](const Eigen::VectorXd& x) {
      if (cancelled()) throw Cancelled();
      return readings(x);
    };
  return response;
}

}  // namespace

Response response_with(const Problem& problem, std::span<const Screened* const> on) {
  return response_with(problem, on, problem.record, problem.observed);
}

Response response_with(const Problem& problem, std::span<const Screened* const> on,
                       const std::shared_ptr<const Record>& record, const Observations& observed) {
  const std::shared_ptr<const void> prepared =
      record == problem.record ? problem.prepared : problem.subject->prepare(*record);
  const std::vector<std::string> names = names_of(problem.base, on);
  if (on.empty())
    return cancellable(problem, response_of(*problem.subject, record, observed, names, prepared));
  const auto with = problem.subject->with_candidates(ids_of(on));
  Response response = cancellable(problem, response_of(*with, record, observed, names, prepared));
  std::size_t at = problem.base.size();
  for (const Screened* s : on)
    for (const Parameter& p : s->candidate.parameters) {
      Parameter& own = response.parameters[at++];
      own.scale = p.scale;
      own.plausible_lower = p.plausible_lower;
      own.plausible_upper = p.plausible_upper;
    }
  return response;
}

std::shared_ptr<const Subject> fitted_subject(const Problem& problem,
                                              std::span<const Screened* const> on,
                                              const Response& response,
                                              const Eigen::VectorXd& values) {
  std::vector<NamedValue> named;
  for (std::size_t k = 0; k < response.parameters.size(); ++k)
    named.push_back({response.parameters[k].name, values[static_cast<Eigen::Index>(k)]});
  if (on.empty()) return problem.subject->with_values(named);
  return problem.subject->with_candidates(ids_of(on))->with_values(named);
}

void screen_candidates(Problem& problem, const Saturation& saturation,
                       const Eigen::VectorXd& base_values) {
  const Eigen::VectorXd without = response_with(problem, {}).readings(base_values);
  for (Screened& s : problem.candidates) {
    if (s.not_testable.empty())
      s.not_testable = why_not_testable(*problem.subject, s.id(), *problem.record);
    s.most.resize(without.size(), 0);
    if (!s.not_testable.empty()) continue;
    Screening screening(problem, base_values, without, s);
    screening.find_scores();
    if (!saturation.proportional) screening.find_most();
    if (!s.not_testable.empty() || s.scores.cols() > 0) continue;
    const std::string levels = problem.subject->lacks_levels(s.id(), *problem.record);
    s.not_testable = levels.empty() ? "the effect changes no reading at these operating points"
                                    : needing(levels);
  }
}

}  // namespace raceway::fit
