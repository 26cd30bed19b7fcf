#include "verdict/visibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/subspace.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

constexpr double told_apart = 20.0;   // the same, left by the best wrong effect
constexpr double alike = 0.98;        // cosine of scores
constexpr double near_enough = 0.01;  // of the size that is sought
constexpr int most_steps = 20;

/// The most visible score of a candidate.
Eigen::Index clearest_score(const Attribution& attribution, std::size_t candidate) {
  const auto [first, count] = attribution.score_range(candidate);
  Eigen::Index best = first;
  for (Eigen::Index j = first; j < first + count; ++j)
    if (attribution.gate().visibility[j] > attribution.gate().visibility[best]) best = j;
  return best;
}

/// Why the data cannot tell an effect from the base parameters.
std::string same_as_base(const fit::Problem& problem, const std::string& id) {
  const std::string levels = problem.subject->lacks_levels(id, *problem.record);
  if (!levels.empty()) return "needs " + levels;
  return joined(problem.base, "and") +
         (problem.base.size() == 1 ? " changes" : " together change") +
         " these readings in the same way as the effect";
}

/// Largest share of the readings of a channel that an effect has.
double share_of_reading(const fit::Observations& observed, const Eigen::VectorXd& change) {
  double share = 0.0;
  for (std::size_t c = 0; c < observed.channels.size(); ++c)
    share = std::max(
        share, fit::rms(observed.of(c, change)) / fit::rms(observed.of(c, observed.measured)));
  return share;
}

/// Sizes at which the effects of `visible` would be found; pairs of effects that are alike.
class Sizes {
 public:
  Sizes(const Evidence& evidence, const Attribution& attribution, std::vector<std::size_t> visible)
      : evidence_(evidence),
        problem_(evidence.problem),
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
      if (beyond(d.size, visible_[i]) && !find_within_range(i, d)) {
        result.not_testable.push_back({d.id, too_little(visible_[i])});
        continue;
      }
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
      const fit::Screened& s = problem_.candidates[visible_[i]];
      const double length = length_of(visible_[i]);
      const double apart = std::sqrt(std::max(0.0, 1.0 - closest * closest)) * length;
      d.told_apart_from = apart > 1e-6 * length
                              ? s.size().neutral + std::sqrt(told_apart) / apart * s.unit_size
                              : unset;
      if (beyond(d.told_apart_from, visible_[i])) d.told_apart_from = unset;
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
    const fit::Screened& s = problem_.candidates[k];
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

  /// True of a size that the parameter cannot have.
  [[nodiscard]] bool beyond(double size, std::size_t k) const {
    const record::Parameter& p = problem_.candidates[k].size();
    return size > p.upper || size < p.lower;
  }
  /// The end of its range on the side that is looked at.
  [[nodiscard]] double end_of_range(std::size_t k) const {
    const fit::Screened& s = problem_.candidates[k];
    return s.unit_size > 0.0 ? s.size().upper : s.size().lower;
  }
  [[nodiscard]] std::string too_little(std::size_t k) const {
    return fmt::format(
        "even at {}, the limit of its range, the effect changes these data too little",
        with_unit(end_of_range(k), problem_.candidates[k].size().unit));
  }

  /// What an effect of that size changes, its shapes as they begin; nothing without a prediction.
  [[nodiscard]] std::optional<Eigen::VectorXd> change_at(std::size_t k,
                                                         const fit::Response& response,
                                                         double size) const {
    const fit::Screened& s = problem_.candidates[k];
    const auto bases = static_cast<Eigen::Index>(problem_.base.size());
    Eigen::VectorXd x = response.start();
    x.head(bases) = evidence_.base.values;
    for (std::size_t j = 0; j < s.candidate.parameters.size(); ++j)
      if (const double neutral = s.candidate.parameters[j].neutral; !std::isnan(neutral))
        x[bases + static_cast<Eigen::Index>(j)] = neutral;
    x[bases + static_cast<Eigen::Index>(s.candidate.size)] = size;
    Eigen::VectorXd change = response.readings(x) - evidence_.base.prediction;
    if (!change.allFinite()) return std::nullopt;
    return change;
  }

  /// Its length off the base, the least under the noises that the readings allow.
  [[nodiscard]] double length_of_change(const Eigen::VectorXd& change) const {
    const fit::ResponseFit& base = evidence_.base;
    double length = fit::project_off(base.tangent, evidence_.whitening(change)).norm();
    std::vector<Eigen::Index> free;
    for (std::size_t j = 0; j < base.at_bound.size(); ++j)
      if (!base.at_bound[j]) free.push_back(static_cast<Eigen::Index>(j));
    const Eigen::MatrixXd slope = base.slope(Eigen::all, free);
    for (const fit::Whitening& other : evidence_.allowed)
      length = std::min(length, fit::project_off(other(slope), other(change)).norm());
    return length;
  }

  /// An effect that grows faster than its size, as that of a tilt does, has next to no score at
  /// none: the size is sought that changes as much as would have been found. False if none within
  /// the range does.
  bool find_within_range(std::size_t i, DetectableSize& d) const {
    const std::size_t k = visible_[i];
    const fit::Screened* const on[] = {&problem_.candidates[k]};
    const fit::Response response = fit::response_with(problem_, on);
    const double needed = attribution_.length_found(), neutral = on[0]->size().neutral;
    double high = end_of_range(k) - neutral, low = 0.0;
    std::optional<Eigen::VectorXd> change = change_at(k, response, neutral + high);
    if (!change || !(length_of_change(*change) >= needed)) return false;
    for (int step = 0; step < most_steps; ++step) {
      if (std::abs(high - low) <= near_enough * std::abs(high)) break;
      const double middle = 0.5 * (low + high);
      std::optional<Eigen::VectorXd> there = change_at(k, response, neutral + middle);
      if (there && length_of_change(*there) >= needed) {
        high = middle;
        change = std::move(there);
      } else {
        low = middle;
      }
    }
    d.size = neutral + high;
    d.share_of_reading = share_of_reading(problem_.observed, *change);
    return true;
  }

  const Evidence& evidence_;
  const fit::Problem& problem_;
  const Attribution& attribution_;
  std::vector<std::size_t> visible_;
  Eigen::VectorXd least_;
  std::vector<bool> grouped_;
  std::vector<Eigen::VectorXd> unit_;
};

}  // namespace

Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution) {
  const fit::Problem& problem = evidence.problem;
  Visibility result;
  std::vector<std::size_t> visible;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const fit::Screened& s = problem.candidates[k];
    if (!s.not_testable.empty())
      result.not_testable.push_back({s.id(), s.not_testable});
    else if (attribution.visibility(k) < invisible)
      result.not_testable.push_back({s.id(), same_as_base(problem, s.id())});
    else
      visible.push_back(k);
  }
  result.tried = visible.size();
  Sizes(evidence, attribution, std::move(visible)).add_to(result);
  return result;
}

}  // namespace raceway::verdict
