#include "model/model_changes.h"

#include <algorithm>

#include "model/parameters.h"
#include "record/units.h"

namespace raceway::model {
namespace {

/// Ids of effects that `model` has and `other` has not.
std::vector<std::string> effects_beyond(const Model& model, const Model& other) {
  std::vector<std::string> ids;
  for (const effects::Effect& e : model.effects)
    if (std::none_of(other.effects.begin(), other.effects.end(), [&](const effects::Effect& o) {
          return o.description->id == e.description->id;
        }))
      ids.emplace_back(e.description->id);
  return ids;
}

}  // namespace

ModelChanges model_changes(const Model& before, const Model& after) {
  ModelChanges changes{.added = effects_beyond(after, before),
                       .removed = effects_beyond(before, after),
                       .numbers = {}};
  const std::vector<record::Parameter> old = parameters(before);
  for (const record::Parameter& p : parameters(after)) {
    if (p.addresses.size() > 1) continue;  // each of these numbers is listed as well
    const auto was = std::find_if(old.begin(), old.end(),
                                  [&](const record::Parameter& o) { return o.name == p.name; });
    const double value = was == old.end() ? unset : was->value;
    if (value != p.value) changes.numbers.push_back({p.name, p.unit, value, p.value});
  }
  const auto add = [&](std::string name, double was, double is) {
    if (was != is)
      changes.numbers.push_back({std::move(name), "mm2/s", was / mm2_per_s, is / mm2_per_s});
  };
  add("viscosity_40C_mm2_s", before.lubricant.viscosity_40C(), after.lubricant.viscosity_40C());
  add("viscosity_100C_mm2_s", before.lubricant.viscosity_100C(), after.lubricant.viscosity_100C());
  return changes;
}

std::vector<ModelChanges> changes_between(const std::vector<Model>& models) {
  std::vector<ModelChanges> changes;
  for (std::size_t i = 1; i < models.size(); ++i)
    changes.push_back(model_changes(models[i - 1], models[i]));
  return changes;
}

}  // namespace raceway::model
