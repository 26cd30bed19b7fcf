#include "report/detail/model_facts.h"

#include "model/parameters.h"
#include "record/units.h"

namespace raceway::report {
namespace {

text::json facts(const ModelOfPage& of) {
  const model::Model& model = of.model;
  text::json factors = text::json::array();
  for (const record::Parameter& p : model::parameters(model))
    factors.push_back({{"name", p.name}, {"value", p.value}, {"unit", p.unit}});
  text::json effects = text::json::array();
  for (const effects::Effect& e : model.effects) effects.push_back(e.description->id);
  return {{"model", of.file},
          {"bearing", model.name},
          {"law", friction::name(model.law)},
          {"factors", factors},
          {"effects", effects},
          {"viscosity_40C_mm2_s", model.lubricant.viscosity_40C() / mm2_per_s},
          {"viscosity_100C_mm2_s", model.lubricant.viscosity_100C() / mm2_per_s},
          {"defaults", files::short_lines(of.defaults)}};
}

}  // namespace

text::json model_facts(const std::vector<ModelOfPage>& models) {
  text::json list = text::json::array();
  for (const ModelOfPage& of : models) list.push_back(facts(of));
  return list;
}

text::json changes_json(const std::vector<model::ModelChanges>& changes) {
  text::json list = text::json::array();
  for (const model::ModelChanges& c : changes) {
    text::json numbers = text::json::array();
    for (const model::ChangedNumber& n : c.numbers)
      numbers.push_back(
          {{"name", n.name}, {"unit", n.unit}, {"before", n.before}, {"after", n.after}});
    list.push_back({{"added", c.added}, {"removed", c.removed}, {"numbers", numbers}});
  }
  return list;
}

}  // namespace raceway::report
