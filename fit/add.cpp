#include "fit/add.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fit/attribution.h"
#include "fit/evidence.h"
#include "fit/nearest_names.h"
#include "fit/needs.h"
#include "fit/quantity.h"

namespace raceway::fit {

namespace {

constexpr double clearly_better = 6.0;  // in -2 ln L, as for the set of a verdict
constexpr double passed = 0.01;         // of the gate

/// The effects to add, ready to be given to a model.
std::vector<effects::Effect> find_effects(const Model& model,
                                          std::span<const effects::Effect> user_made,
                                          std::span<const std::string> ids, Quantity measured) {
  const effects::Subject subject = subject_of(measured);
  if (ids.empty()) throw std::invalid_argument("no effect to add");
  std::vector<effects::Effect> found;
  for (const std::string& id : ids) {
    const auto named = [&](const effects::Effect& e) { return e.description->id == id; };
    if (std::any_of(model.effects.begin(), model.effects.end(), named))
      throw std::invalid_argument(fmt::format("{}: the model has this effect already", id));
    if (std::any_of(found.begin(), found.end(), named))
      throw std::invalid_argument(fmt::format("{} is listed twice", id));
    const std::optional<effects::Effect> effect = find_effect(id, user_made, subject);
    if (!effect) {
      std::vector<std::string> known;
      for (const effects::Effect& e : user_made) known.emplace_back(e.description->id);
      for (const effects::Description* e : catalogue_of(subject)) known.emplace_back(e->id);
      throw std::invalid_argument(
          fmt::format("unknown effect \"{}\"; nearest: {}", id, nearest_names(id, known, 3)));
    }
    if (!effect->description->moves(subject))
      throw std::invalid_argument(fmt::format("{}: does not change the {}, which is measured", id,
                                              text_of(measured).in_words));
    found.push_back(*effect);
  }
  return found;
}

double rms_of(const std::vector<HoldOut>& results, double HoldOut::*rmse) {
  if (results.empty()) return unset;
  double sum = 0.0;
  for (const HoldOut& h : results) sum += h.*rmse * h.*rmse;
  return std::sqrt(sum / static_cast<double>(results.size()));
}

/// The single effect that leaves nothing but noise, where what was asked for leaves structure.
std::optional<Explanation> better_rival(const Attribution& attribution, Explanation& asked) {
  attribution.recheck(asked);
  if (asked.members.size() != 1 || asked.recheck.p_value() >= passed) return std::nullopt;
  for (Explanation& single : attribution.singles()) {
    if (!single.fit.converged || single.gain < asked.gain + clearly_better) break;
    attribution.recheck(single);
    if (single.recheck.p_value() >= passed) return std::move(single);
  }
  return std::nullopt;
}

/// The id of a member without which the others explain as much; empty if none, or only one is
/// there.
std::string idle_member(const Attribution& attribution, const Problem& problem,
                        const Explanation& asked, double needed) {
  if (asked.members.size() < 2) return "";
  for (const std::size_t k : asked.members) {
    std::vector<std::size_t> others = asked.members;
    std::erase(others, k);
    const Explanation without = attribution.refit(others);
    if (without.fit.converged && asked.gain - without.gain < needed)
      return problem.candidates[k].id;
  }
  return "";
}

}  // namespace

AddResult add(const Model& model, std::span<const std::string> ids, const DataSet& data) {
  Model before = model;
  const std::vector<effects::Effect> user_made = take_user_made(before);
  const std::vector<effects::Effect> wanted = find_effects(before, user_made, ids, data.quantity);
  std::vector<const effects::Description*> candidates;
  for (const effects::Effect& e : wanted) candidates.push_back(e.description);
  for (const effects::Description* d : catalogue_of(subject_of(data.quantity)))
    if (std::find(candidates.begin(), candidates.end(), d) == candidates.end())
      candidates.push_back(d);
  const Evidence evidence = gather_evidence(before, data, candidates, most_rows_of_a_fit);
  const Problem& problem = evidence.problem;
  const Attribution attribution(problem, evidence.noise, evidence.base, evidence.size);
  std::vector<std::size_t> members;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const Candidate& c = problem.candidates[k];
    if (std::none_of(wanted.begin(), wanted.end(),
                     [&](const auto& e) { return e.description == c.description; }))
      continue;
    if (!c.not_testable.empty())
      throw std::invalid_argument(fmt::format("{}: the data lack {}", c.id, c.not_testable));
    if (attribution.visibility(k) < invisible) {
      const std::string levels = missing_levels(*c.description, before, problem.data);
      throw std::invalid_argument(
          levels.empty()
              ? fmt::format("{}: on these data the free parameters of the model do the same", c.id)
              : fmt::format("{}: the data lack {}", c.id, levels));
    }
    members.push_back(k);
  }
  if (members.size() != wanted.size())
    throw std::invalid_argument("an effect without a size cannot be added");
  Explanation found = attribution.refit(members);

  // The model as it will be written: effects in the order asked for, values where the refit ended.
  Model extended = before;
  extended.free = problem.base;
  for (const effects::Effect& effect : wanted) {
    extended.effects.push_back(effect);
    std::size_t at = problem.base.size();
    for (const std::size_t k : members) {
      const Candidate& c = problem.candidates[k];
      for (std::size_t j = 0; j < c.parameters.size(); ++j, ++at) {
        if (c.description != effect.description) continue;
        if (found.fit.converged)
          extended.effects.back().values[j] = found.fit.values[static_cast<Eigen::Index>(at)];
        extended.free.push_back(c.qualified(j));
      }
    }
  }
  if (found.fit.converged) {
    for (const ModelParameter& p : free_parameters(extended)) {
      const auto at = std::find(problem.base.begin(), problem.base.end(), p.name);
      if (at != problem.base.end()) p.set(extended, found.fit.values[at - problem.base.begin()]);
    }
  }
  DataSet weighted = problem.data;
  const bool declared = std::all_of(weighted.rows.begin(), weighted.rows.end(),
                                    [](const Row& row) { return row.std > 0.0; });
  if (!declared)
    for (std::size_t i = 0; i < weighted.rows.size(); ++i)
      weighted.rows[i].std = evidence.noise.whitening.std()[static_cast<Eigen::Index>(i)];

  const auto list = [](const Eigen::VectorXd& v) {
    return std::vector<double>(v.data(), v.data() + v.size());
  };
  AddResult result{.calibration = calibrate(extended, weighted)};
  result.before =
      compare(list(evidence.base.prediction), problem.data, static_cast<int>(problem.base.size()));
  result.after =
      compare(result.calibration.model, problem.data, static_cast<int>(extended.free.size()));
  result.noise = evidence.noise;
  result.messages = result.calibration.messages;
  if (!found.fit.converged || !result.calibration.converged()) {
    result.refused = true;
    result.reason = "the fit with the effect did not converge";
    return result;
  }
  const Eigen::VectorXd& std = evidence.noise.whitening.std();
  for (const Blocking& b : blockings(problem.data))
    result.hold_out.push_back(compare_held_out(
        held_out_errors(evidence.response, evidence.base, problem.measured, std, b),
        held_out_errors(found.response, found.fit, problem.measured, std, b), std, b));
  result.rmse_held_out_before = rms_of(result.hold_out, &HoldOut::rmse_before);
  result.rmse_held_out_after = rms_of(result.hold_out, &HoldOut::rmse_after);
  // What else is missing shows as more than noise, and by chance a wrong effect takes part of it.
  const auto rows = static_cast<double>(problem.measured.size());
  const double excess =
      std::max(1.0, found.fit.misfit / (rows - static_cast<double>(found.fit.values.size())));
  const double needed_each = excess * std::log(rows);
  const double needed = needed_each * static_cast<double>(members.size());
  if (!confirmed(result.hold_out) || found.gain < needed) {
    const QuantityText quantity = text_of(data.quantity);
    result.refused = true;
    result.reason = fmt::format(
        "no better than chance: {:.4g} -> {:.4g} {} on rows that the fit did not see, fall of "
        "-2 ln L by {:.1f} (needed {:.1f})",
        result.rmse_held_out_before / quantity.factor, result.rmse_held_out_after / quantity.factor,
        quantity.unit, found.gain, needed);
  } else if (const std::string idle = idle_member(attribution, problem, found, needed_each);
             !idle.empty()) {
    result.refused = true;
    result.reason = idle + " adds nothing beside the others";
  } else if (const auto rival = better_rival(attribution, found)) {
    result.refused = true;
    result.reason = fmt::format(
        "{} leaves structure (p = {:.1g}), and {} explains these data to the noise (p = {:.2g})",
        ids.front(), found.recheck.p_value(), problem.candidates[rival->members.front()].id,
        rival->recheck.p_value());
  }
  return result;
}

}  // namespace raceway::fit
