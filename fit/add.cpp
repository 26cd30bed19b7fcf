#include "fit/add.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "effects/catalogue.h"
#include "fit/attribution.h"
#include "fit/evidence.h"

namespace raceway::fit {

namespace {

constexpr int most_rows = 4000;

std::string nearest_ids(const std::string& id) {
  // Ids that share most pairs of letters.
  const auto alike = [&](std::string_view other) {
    double count = 0.0;
    for (std::size_t k = 0; k + 1 < id.size(); ++k)
      if (other.find(id.substr(k, 2)) != std::string_view::npos) count += 1.0;
    return count / static_cast<double>(std::max(id.size(), other.size()));
  };
  std::vector<std::string_view> ids;
  for (const effects::Description& d : effects::catalogue()) ids.push_back(d.id);
  std::stable_sort(ids.begin(), ids.end(),
                   [&](std::string_view a, std::string_view b) { return alike(a) > alike(b); });
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, ids.size()); ++k)
    text += (k == 0 ? "" : ", ") + std::string(ids[k]);
  return text;
}

void require_new(const Model& model, std::span<const effects::Description* const> effects) {
  if (effects.empty()) throw std::invalid_argument("no effect to add");
  for (std::size_t k = 0; k < effects.size(); ++k) {
    for (const effects::Effect& e : model.effects)
      if (e.description->id == effects[k]->id)
        throw std::invalid_argument(
            fmt::format("{}: the model has this effect already", effects[k]->id));
    for (std::size_t j = 0; j < k; ++j)
      if (effects[j]->id == effects[k]->id)
        throw std::invalid_argument(fmt::format("{} is listed twice", effects[k]->id));
  }
}

double rms_of(const std::vector<HoldOut>& results, double HoldOut::*rmse) {
  if (results.empty()) return unset;
  double sum = 0.0;
  for (const HoldOut& h : results) sum += h.*rmse * h.*rmse;
  return std::sqrt(sum / static_cast<double>(results.size()));
}

}  // namespace

AddResult add(const Model& model, std::span<const effects::Description* const> effects,
              const DataSet& data) {
  require_new(model, effects);
  const Evidence evidence = gather_evidence(model, data, effects, most_rows);
  const Problem& problem = evidence.problem;
  const Attribution attribution(problem, evidence.noise, evidence.base, evidence.size);
  std::vector<std::size_t> members;
  std::vector<const Candidate*> on;
  for (std::size_t k = 0; k < problem.candidates.size(); ++k) {
    const Candidate& c = problem.candidates[k];
    if (!c.not_testable.empty())
      throw std::invalid_argument(fmt::format("{}: the data lack {}", c.id, c.not_testable));
    if (attribution.visibility(k) < invisible)
      throw std::invalid_argument(
          fmt::format("{}: on these data the free parameters of the model do the same", c.id));
    members.push_back(k);
    on.push_back(&c);
  }
  if (members.size() != effects.size())
    throw std::invalid_argument("an effect without a size cannot be added");
  const Explanation found = attribution.refit(members);

  // The model as it will be written: effects in the order asked for, values where the refit ended.
  Model extended = model;
  extended.free = problem.base;
  for (const effects::Description* d : effects) {
    effects::Effect effect;
    effect.description = d;
    effect.values = effects::initial_values(*d);
    std::size_t at = problem.base.size();
    for (const Candidate* c : on) {
      for (std::size_t k = 0; k < c->parameters.size(); ++k, ++at) {
        if (c->description != d) continue;
        if (found.fit.converged) effect.values[k] = found.fit.values[static_cast<Eigen::Index>(at)];
        extended.free.push_back(c->qualified(k));
      }
    }
    extended.effects.push_back(std::move(effect));
  }
  if (found.fit.converged) {
    const std::vector<ModelParameter> base = free_parameters(model);
    for (std::size_t k = 0; k < base.size(); ++k)
      base[k].set(extended, found.fit.values[static_cast<Eigen::Index>(k)]);
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
  const double needed = excess * std::log(rows) * static_cast<double>(members.size());
  if (!confirmed(result.hold_out) || found.gain < needed) {
    result.refused = true;
    result.reason = fmt::format(
        "no better than chance: {:.4g} -> {:.4g} N mm on rows that the fit did not see, fall of "
        "-2 ln L by {:.1f} (needed {:.1f})",
        result.rmse_held_out_before / N_mm, result.rmse_held_out_after / N_mm, found.gain, needed);
  }
  return result;
}

AddResult add(const Model& model, std::span<const std::string> ids, const DataSet& data) {
  std::vector<const effects::Description*> effects;
  for (const std::string& id : ids) {
    effects.push_back(effects::find(id));
    if (effects.back() == nullptr)
      throw std::invalid_argument("unknown effect \"" + id + "\"; nearest: " + nearest_ids(id));
  }
  return add(model, effects, data);
}

}  // namespace raceway::fit
