#include "fit/effect_sizes.h"

#include <fmt/format.h>

#include <cmath>

#include "fit/verdict_text.h"

namespace raceway::fit {

namespace {

constexpr double plausible_factor = 3.0;

}  // namespace

std::vector<EffectSize> sizes_of(const Problem& problem, const Explanation& e, std::size_t member) {
  std::vector<EffectSize> list;
  std::size_t at = problem.base.size();
  for (const std::size_t k : e.members) {
    const Candidate& c = problem.candidates[k];
    for (std::size_t j = 0; j < c.parameters.size(); ++j, ++at) {
      if (k != member) continue;
      const effects::Parameter& p = c.description->parameters[j];
      EffectSize s{.name = c.parameters[j].name, .unit = c.parameters[j].unit};
      s.value = e.fit.values[static_cast<Eigen::Index>(at)];
      s.std = e.fit.standard_errors[static_cast<Eigen::Index>(at)];
      s.plausible_lower = p.plausible_lower;
      // What else turns on the shaft of a coast-down has no published size.
      const bool rotor =
          c.description->grows_with_the_rotor && std::isfinite(problem.model.rig.inertia);
      s.plausible_upper = rotor ? p.upper : p.plausible_upper;
      s.at_bound = e.fit.at_bound[at];
      const double margin = std::isfinite(s.std) ? 2.0 * s.std : 0.0;
      const double neutral = std::isnan(p.neutral) ? 0.0 : p.neutral;
      const double low = s.plausible_lower - neutral, high = s.plausible_upper - neutral;
      const double value = s.value - neutral;
      s.plausible =
          value - margin <= (high > 0.0 ? high * plausible_factor : high / plausible_factor) &&
          value + margin >= (low > 0.0 ? low / plausible_factor : low * plausible_factor);
      list.push_back(s);
    }
  }
  return list;
}

bool sizes_plausible(const Problem& problem, const Explanation& e) {
  for (const std::size_t k : e.members)
    if (!sizes_of(problem, e, k)[problem.candidates[k].size_index].plausible) return false;
  return true;
}

std::string size_text(const Problem& problem, const Explanation& e) {
  std::vector<std::string> texts;
  for (const std::size_t k : e.members) {
    const EffectSize s = sizes_of(problem, e, k)[problem.candidates[k].size_index];
    std::string text = fmt::format("{} = {:.3g}", s.name, s.value);
    if (std::isfinite(s.std)) text += fmt::format(" +- {:.2g}", s.std);
    if (s.unit != "1") text += " " + s.unit;
    texts.push_back(std::move(text));
  }
  return joined(texts, "and");
}

Interval size_interval(const Evidence& evidence, const Explanation& e, std::size_t member) {
  if (e.elastic) return {};
  std::size_t at = evidence.problem.base.size();
  for (const std::size_t k : e.members) {
    const Candidate& c = evidence.problem.candidates[k];
    if (k == member)
      return profile_interval(e.response, e.fit, evidence.noise.whitening,
                              evidence.problem.measured, at + c.size_index);
    at += c.parameters.size();
  }
  return {};
}

std::vector<BaseShift> base_shifts(const Evidence& evidence, const Explanation& e) {
  const Problem& problem = evidence.problem;
  std::vector<BaseShift> list;
  for (std::size_t k = 0; k < problem.base.size(); ++k)
    list.push_back({.name = problem.base[k],
                    .unit = evidence.response.parameters[k].unit,
                    .before = evidence.base.values[static_cast<Eigen::Index>(k)],
                    .after = e.fit.values[static_cast<Eigen::Index>(k)],
                    .std = e.fit.standard_errors[static_cast<Eigen::Index>(k)]});
  return list;
}

double cross_validated(const Evidence& evidence, const Explanation& e,
                       const std::vector<Blocking>& blockings) {
  const Problem& problem = evidence.problem;
  if (e.elastic || blockings.empty()) return unset;
  double sum = 0.0;
  for (const Blocking& b : blockings)
    sum += held_out_errors(e.response, e.fit, problem.measured, evidence.noise.whitening.std(), b)
               .squaredNorm() /
           static_cast<double>(problem.measured.size());
  return std::sqrt(sum / static_cast<double>(blockings.size()));
}

}  // namespace raceway::fit
