#include "fit/candidates.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "fit/needs.h"

namespace raceway::fit {

namespace {

constexpr double score_step = 1e-3;  // of the typical size of an effect

double typical_size(const effects::Parameter& p) {
  const double neutral = std::isnan(p.neutral) ? 0.0 : p.neutral;
  const double size = std::max(
      std::abs(p.initial - neutral),
      std::isfinite(p.plausible_upper) ? 0.5 * std::abs(p.plausible_upper - neutral) : 0.0);
  if (size > 0.0) return size;
  const double range = p.upper - p.lower;
  return std::isfinite(range) && range > 0.0 ? 0.01 * range : 1.0;
}

}  // namespace

std::string Candidate::qualified(std::size_t parameter) const {
  return id + "." + parameters[parameter].name;
}

std::vector<effects::Effect> take_user_made(Model& model) {
  std::vector<effects::Effect> taken;
  std::erase_if(model.effects, [&](const effects::Effect& e) {
    const auto& parameters = e.description->parameters;
    const bool has_size = std::any_of(parameters.begin(), parameters.end(),
                                      [](const auto& p) { return !std::isnan(p.neutral); });
    if (!e.description->user_made || !has_size ||
        e.values != effects::neutral_values(*e.description))
      return false;
    taken.push_back(e);
    return true;
  });
  return taken;
}

std::optional<effects::Effect> find_effect(std::string_view id,
                                           std::span<const effects::Effect> user_made,
                                           effects::Subject subject) {
  for (const effects::Effect& e : user_made)
    if (e.description->id == id) return e;
  const effects::Description* d = effects::find(id, subject);
  if (d == nullptr) return std::nullopt;
  effects::Effect effect;
  effect.description = d;
  effect.values = effects::initial_values(*d);
  return effect;
}

std::vector<const effects::Description*> catalogue_of(effects::Subject subject) {
  std::vector<const effects::Description*> list;
  for (const effects::Description& d : effects::catalogue(subject))
    if (d.moves(subject)) list.push_back(&d);
  return list;
}

std::vector<Candidate> make_candidates(const Model& model,
                                       std::span<const effects::Description* const> descriptions) {
  std::vector<Candidate> candidates;
  for (const effects::Description* d : descriptions) {
    const auto same = [&](const effects::Effect& e) { return e.description->id == d->id; };
    if (std::any_of(model.effects.begin(), model.effects.end(), same)) continue;
    Candidate c{.description = d, .id = std::string(d->id)};
    bool found = false;
    for (std::size_t k = 0; k < d->parameters.size(); ++k) {
      const effects::Parameter& p = d->parameters[k];
      c.parameters.push_back({.name = std::string(p.name),
                              .unit = std::string(p.unit),
                              .start = p.initial,
                              .lower = p.lower,
                              .upper = p.upper,
                              .scale = typical_size(p)});
      c.neutral.push_back(p.neutral);
      if (found || std::isnan(p.neutral)) continue;
      found = true;
      c.size_index = k;
      const double span = typical_size(p);
      c.one_sided = p.lower >= p.neutral - 1e-9 * span || p.upper <= p.neutral + 1e-9 * span;
      c.unit_size = p.upper <= p.neutral + 1e-9 * span ? -span : span;
    }
    if (found) candidates.push_back(std::move(c));
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.id < b.id; });
  candidates.erase(std::unique(candidates.begin(), candidates.end(),
                               [](const Candidate& a, const Candidate& b) { return a.id == b.id; }),
                   candidates.end());
  return candidates;
}

Response response_with(const Problem& problem, std::span<const Candidate* const> on) {
  Model model = problem.model;
  std::vector<std::string> names = problem.base;
  std::vector<double> scale;
  for (const Candidate* c : on) {
    effects::Effect effect;
    effect.description = c->description;
    effect.values = effects::initial_values(*c->description);
    model.effects.push_back(std::move(effect));
    for (std::size_t k = 0; k < c->parameters.size(); ++k) {
      names.push_back(c->qualified(k));
      scale.push_back(c->parameters[k].scale);
    }
  }
  Response response = model_response(model, problem.data, names, problem.balances);
  for (std::size_t k = 0; k < scale.size(); ++k)
    response.parameters[problem.base.size() + k].scale = scale[k];
  return response;
}

void screen_candidates(Problem& problem, const Eigen::VectorXd& base_values) {
  const auto bases = static_cast<Eigen::Index>(problem.base.size());
  const Eigen::VectorXd without = response_with(problem, {}).readings(base_values);
  for (Candidate& c : problem.candidates) {
    c.not_testable = missing_need(*c.description, problem.model, problem.data);
    if (!c.not_testable.empty()) continue;
    const Candidate* const one[] = {&c};
    const Response response = response_with(problem, one);
    Eigen::VectorXd x = response.start();
    x.head(bases) = base_values;
    std::vector<std::size_t> shapes;
    for (std::size_t k = 0; k < c.neutral.size(); ++k) {
      if (std::isnan(c.neutral[k]))
        shapes.push_back(k);
      else
        x[bases + static_cast<Eigen::Index>(k)] = c.neutral[k];
    }
    // Each shape at its start and towards both bounds.
    std::vector<Eigen::VectorXd> points{x};
    for (const std::size_t k : shapes) {
      const FitParameter& p = c.parameters[k];
      for (const double part : {0.1, 0.9}) {
        Eigen::VectorXd y = x;
        y[bases + static_cast<Eigen::Index>(k)] = p.lower + part * (p.upper - p.lower);
        if (y.allFinite()) points.push_back(y);
      }
    }
    // Nothing is known of the size of a formula: a tenth of the torque is its scale.
    if (c.description->user_made) {
      Eigen::VectorXd y = x;
      y[bases + static_cast<Eigen::Index>(c.size_index)] += c.unit_size;
      const double change = (response.readings(y) - without).norm() / std::abs(c.unit_size);
      if (std::isfinite(change) && change > 0.0) {
        c.unit_size *= 0.1 * without.norm() / (change * std::abs(c.unit_size));
        c.parameters[c.size_index].scale = std::abs(c.unit_size);
      }
    }
    c.scores.resize(without.size(), static_cast<Eigen::Index>(points.size()));
    Eigen::Index count = 0;
    for (Eigen::VectorXd& point : points) {
      double& size = point[bases + static_cast<Eigen::Index>(c.size_index)];
      const double step = score_step * c.unit_size;
      size += step;
      const Eigen::VectorXd column = (response.readings(point) - without) / score_step;
      if (!column.allFinite()) {
        c.not_testable = "rows at which the bearing with this effect is in balance";
        break;
      }
      if (column.cwiseAbs().maxCoeff() > 1e-9 * without.cwiseAbs().maxCoeff())
        c.scores.col(count++) = column;
    }
    c.scores.conservativeResize(Eigen::NoChange, count);
    c.most.resize(without.size(), 0);
    if (problem.data.quantity == Quantity::axial_displacement) {
      const effects::Parameter& p = c.description->parameters[c.size_index];
      x[bases + static_cast<Eigen::Index>(c.size_index)] =
          std::clamp(c.unit_size > 0.0 ? p.plausible_upper : p.plausible_lower, p.lower, p.upper);
      const Eigen::VectorXd change = response.readings(x) - without;
      if (change.allFinite()) c.most = change;
    }
    if (!c.not_testable.empty() || count > 0) continue;
    c.not_testable = missing_levels(*c.description, problem.model, problem.data);
    if (c.not_testable.empty())
      c.not_testable = "a quantity on which it has any effect at these operating points";
  }
}

}  // namespace raceway::fit
