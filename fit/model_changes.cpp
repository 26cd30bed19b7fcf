#include "fit/model_changes.h"

#include <algorithm>

#include "fit/free_parameters.h"

namespace raceway::fit {
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
  const std::vector<ModelParameter> old = model_parameters(before);
  for (const ModelParameter& p : model_parameters(after)) {
    if (p.shaft == ShaftNumber::conformity) continue;  // that of each groove is listed as well
    const auto was = std::find_if(old.begin(), old.end(),
                                  [&](const ModelParameter& o) { return o.name == p.name; });
    const double value = was == old.end() ? unset : was->get(before);
    if (value != p.get(after)) changes.numbers.push_back({p.name, p.unit, value, p.get(after)});
  }
  return changes;
}

}  // namespace raceway::fit
