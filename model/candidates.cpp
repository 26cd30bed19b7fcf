#include "model/candidates.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "model/parameters.h"

namespace raceway::model {
namespace {

bool has_size(const effects::Parameter& p) { return !std::isnan(p.neutral); }

/// Half the way to the end of what is met, or the initial value where that is further.
double typical_size(const effects::Parameter& p) {
  const double neutral = has_size(p) ? p.neutral : 0.0;
  const double size = std::max(
      std::abs(p.initial - neutral),
      std::isfinite(p.plausible_upper) ? 0.5 * std::abs(p.plausible_upper - neutral) : 0.0);
  if (size > 0.0) return size;
  const double range = p.upper - p.lower;
  return std::isfinite(range) && range > 0.0 ? 0.01 * range : 1.0;
}

}  // namespace

bool is_free(const Model& model, std::string_view id) {
  const std::string prefix = std::string(id) + ".";
  return std::any_of(model.free.begin(), model.free.end(),
                     [&](const std::string& name) { return name.starts_with(prefix); });
}

std::vector<std::string> waiting_effects(const Model& model) {
  std::vector<std::string> ids;
  for (const effects::Effect& e : model.effects) {
    const effects::Description& d = *e.description;
    if (d.user_made && std::any_of(d.parameters.begin(), d.parameters.end(), has_size) &&
        e.values == effects::neutral_values(d) && !is_free(model, d.id))
      ids.emplace_back(d.id);
  }
  return ids;
}

std::optional<fit::Candidate> candidate_of(const effects::Description& effect, const Model& model) {
  fit::Candidate c{.id = std::string(effect.id)};
  c.base_law = effect.base_law;
  c.empirical = effect.empirical;
  c.datum = effect.datum;
  c.of_the_user = effect.user_made != nullptr;
  c.of_each_record = effect.of_each_record;
  c.of_time = std::find(effect.needs.begin(), effect.needs.end(), effects::Need::time) !=
              effect.needs.end();
  for (const effects::Parameter& p : effect.parameters) {
    const auto [lower, upper] = bounds_of(p, model);
    const auto [usual_lower, usual_upper] = plausible_range(effect, p, model);
    const double initial = std::clamp(p.initial, lower, upper);
    c.parameters.push_back({.name = c.id + "." + std::string(p.name),
                            .unit = std::string(p.unit),
                            .start = initial,
                            .value = initial,
                            .initial = initial,
                            .lower = lower,
                            .upper = upper,
                            .plausible_lower = usual_lower,
                            .plausible_upper = usual_upper,
                            .neutral = p.neutral,
                            .scale = typical_size(p)});
  }
  const auto size = std::find_if(effect.parameters.begin(), effect.parameters.end(), has_size);
  if (size == effect.parameters.end()) return std::nullopt;
  c.size = static_cast<std::size_t>(size - effect.parameters.begin());
  return c;
}

std::vector<std::string> settling_records(effects::Form form,
                                          const std::vector<std::vector<std::string>>& rivals) {
  std::vector<std::string> records;
  for (const effects::Description& d : effects::catalogue(form)) {
    const bool named = std::any_of(rivals.begin(), rivals.end(), [&](const auto& set) {
      return std::find(set.begin(), set.end(), d.id) != set.end();
    });
    if (named && !d.settled_by.empty() &&
        std::find(records.begin(), records.end(), d.settled_by) == records.end())
      records.emplace_back(d.settled_by);
  }
  return records;
}

}  // namespace raceway::model
