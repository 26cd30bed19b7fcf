#include "fit/visibility.h"

#include <algorithm>
#include <cmath>

#include "fit/needs.h"
#include "fit/verdict_text.h"

namespace raceway::fit {

namespace {

constexpr double detected = 25.0;    // squared misfit over variance: found in 99 of 100
constexpr double told_apart = 20.0;  // the same, left by the best wrong effect
constexpr double alike = 0.98;       // cosine of scores

double rms(const Eigen::VectorXd& v) { return v.norm() / std::sqrt(static_cast<double>(v.size())); }

/// The most visible score of a candidate.
Eigen::Index clearest_score(const Attribution& attribution, std::size_t candidate) {
  const auto [first, count] = attribution.score_range(candidate);
  Eigen::Index best = first;
  for (Eigen::Index j = first; j < first + count; ++j)
    if (attribution.gate().visibility[j] > attribution.gate().visibility[best]) best = j;
  return best;
}

/// Why the data cannot tell an effect from the base parameters.
std::string same_as_base(const Problem& problem, const effects::Description& effect) {
  const std::string levels = missing_levels(effect, problem.model, problem.data);
  if (!levels.empty()) return "the data lack " + levels;
  return "on these data " + joined(problem.base, "and") +
         (problem.base.size() == 1 ? " does" : " together do") + " the same";
}

}  // namespace

Visibility what_can_be_seen(const Problem& problem, const Attribution& attribution) {
  Visibility result;
  const Gate& gate = attribution.gate();
  std::vector<std::size_t> visible;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const Candidate& c = problem.candidates[k];
    if (!c.not_testable.empty())
      result.not_testable.push_back({c.id, "the data lack " + c.not_testable});
    else if (attribution.visibility(k) < invisible)
      result.not_testable.push_back({c.id, same_as_base(problem, *c.description)});
    else
      visible.push_back(k);
  }
  const double reading = rms(problem.measured);
  std::vector<Eigen::VectorXd> unit;
  for (const std::size_t k : visible)
    unit.push_back(gate.projected.col(clearest_score(attribution, k)).normalized());
  std::vector<bool> grouped(visible.size(), false);
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const std::size_t k = visible[i];
    const Candidate& c = problem.candidates[k];
    const Eigen::Index score = clearest_score(attribution, k);
    const double length = gate.projected.col(score).norm();
    DetectableSize d{.id = c.id,
                     .parameter = c.parameters[c.size_index].name,
                     .unit = c.parameters[c.size_index].unit};
    const double units = std::sqrt(detected) / length;
    d.size = c.neutral[c.size_index] + units * c.unit_size;
    d.share_of_reading =
        units * rms(c.scores.col(score - attribution.score_range(k).first)) / reading;
    double closest = 0.0;
    std::vector<std::string> group{c.id};
    for (std::size_t j = 0; j < visible.size(); ++j) {
      if (j == i) continue;
      const double cosine = std::abs(unit[i].dot(unit[j]));
      if (cosine > closest) {
        closest = cosine;
        d.most_alike = problem.candidates[visible[j]].id;
      }
      if (cosine > alike && j > i && !grouped[i]) {
        group.push_back(problem.candidates[visible[j]].id);
        grouped[j] = true;
      }
    }
    const double apart = std::sqrt(std::max(0.0, 1.0 - closest * closest)) * length;
    d.told_apart_from = apart > 1e-6 * length
                            ? c.neutral[c.size_index] + std::sqrt(told_apart) / apart * c.unit_size
                            : unset;
    result.would_have_been_found.push_back(d);
    if (group.size() > 1) result.aliases.push_back(group);
  }
  return result;
}

}  // namespace raceway::fit
