#include "fit/visibility.h"

#include <algorithm>
#include <cmath>

#include "fit/verdict_text.h"

namespace raceway::fit {

namespace {

constexpr double told_apart = 20.0;  // the same, left by the best wrong effect
constexpr double alike = 0.98;       // cosine of scores

/// The most visible score of a candidate.
Eigen::Index clearest_score(const Attribution& attribution, std::size_t candidate) {
  const auto [first, count] = attribution.score_range(candidate);
  Eigen::Index best = first;
  for (Eigen::Index j = first; j < first + count; ++j)
    if (attribution.gate().visibility[j] > attribution.gate().visibility[best]) best = j;
  return best;
}

/// Why the data cannot tell an effect from the base parameters.
std::string same_as_base(const Problem& problem, const std::string& id) {
  const std::string levels = problem.subject->lacks_levels(id, *problem.record);
  if (!levels.empty()) return "the data lack " + levels;
  return "on these data " + joined(problem.base, "and") +
         (problem.base.size() == 1 ? " does" : " together do") + " the same";
}

/// Largest share of the readings of a channel that an effect has.
double share_of_reading(const Observations& observed, const Eigen::VectorXd& change) {
  double share = 0.0;
  for (std::size_t c = 0; c < observed.channels.size(); ++c)
    share = std::max(share, rms(observed.of(c, change)) / rms(observed.of(c, observed.measured)));
  return share;
}

/// Sizes at which the effects of `visible` would be found; pairs of effects that are alike.
class Sizes {
 public:
  Sizes(const Problem& problem, const Attribution& attribution, std::vector<std::size_t> visible)
      : problem_(problem),
        attribution_(attribution),
        visible_(std::move(visible)),
        least_(attribution.least_lengths()),
        grouped_(visible_.size(), false) {
    for (const std::size_t k : visible_)
      unit_.push_back(
          attribution.gate().projected.col(clearest_score(attribution, k)).normalized());
  }

  void add_to(Visibility& result) {
    for (std::size_t i = 0; i < visible_.size(); ++i) {
      double closest = 0.0;
      DetectableSize d = detectable(i);
      std::vector<std::string> group{d.id};
      for (std::size_t j = 0; j < visible_.size(); ++j) {
        if (j == i) continue;
        const double cosine = std::abs(unit_[i].dot(unit_[j]));
        if (cosine > closest) {
          closest = cosine;
          d.most_alike = problem_.candidates[visible_[j]].id();
        }
        if (cosine > alike && j > i && !grouped_[i]) {
          group.push_back(problem_.candidates[visible_[j]].id());
          grouped_[j] = true;
        }
      }
      const Screened& s = problem_.candidates[visible_[i]];
      const double length = length_of(visible_[i]);
      const double apart = std::sqrt(std::max(0.0, 1.0 - closest * closest)) * length;
      d.told_apart_from = apart > 1e-6 * length
                              ? s.size().neutral + std::sqrt(told_apart) / apart * s.unit_size
                              : unset;
      result.would_have_been_found.push_back(std::move(d));
      if (group.size() > 1) result.aliases.push_back(std::move(group));
    }
  }

 private:
  [[nodiscard]] double length_of(std::size_t candidate) const {
    return attribution_.gate().projected.col(clearest_score(attribution_, candidate)).norm();
  }

  [[nodiscard]] DetectableSize detectable(std::size_t i) const {
    const std::size_t k = visible_[i];
    const Screened& s = problem_.candidates[k];
    const Eigen::Index score = clearest_score(attribution_, k);
    const double units = attribution_.length_found() / least_[score];
    DetectableSize d{
        .id = s.id(), .parameter = s.candidate.short_name(s.candidate.size), .unit = s.size().unit};
    d.size = s.size().neutral + units * s.unit_size;
    d.share_of_reading =
        units * share_of_reading(problem_.observed,
                                 s.scores.col(score - attribution_.score_range(k).first));
    return d;
  }

  const Problem& problem_;
  const Attribution& attribution_;
  std::vector<std::size_t> visible_;
  Eigen::VectorXd least_;
  std::vector<bool> grouped_;
  std::vector<Eigen::VectorXd> unit_;
};

}  // namespace

Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution) {
  const Problem& problem = evidence.problem;
  Visibility result;
  std::vector<std::size_t> visible;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const Screened& s = problem.candidates[k];
    if (!s.not_testable.empty())
      result.not_testable.push_back({s.id(), s.not_testable});
    else if (attribution.visibility(k) < invisible)
      result.not_testable.push_back({s.id(), same_as_base(problem, s.id())});
    else
      visible.push_back(k);
  }
  Sizes(problem, attribution, std::move(visible)).add_to(result);
  return result;
}

}  // namespace raceway::fit
