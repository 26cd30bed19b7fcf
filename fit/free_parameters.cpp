#include "fit/free_parameters.h"

#include <algorithm>
#include <stdexcept>

#include "fit/nearest_names.h"

namespace raceway::fit {

namespace {

std::string unknown_name(const std::string& name, const std::vector<ModelParameter>& known) {
  std::vector<std::string> names;
  for (const ModelParameter& p : known) names.push_back(p.name);
  return "free parameter \"" + name +
         "\": the model has no such parameter; nearest: " + nearest_names(name, names, 4);
}

/// `parameters` are those of a base law or of an effect.
template <typename Parameter>
void append(std::vector<ModelParameter>& list, std::span<const Parameter> parameters,
            const std::string& prefix, int effect) {
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter& p = parameters[k];
    list.push_back({.name = prefix + std::string(p.name),
                    .unit = std::string(p.unit),
                    .initial = p.initial,
                    .lower = p.lower,
                    .upper = p.upper,
                    .effect = effect,
                    .index = k});
    if constexpr (requires { p.neutral; }) {
      list.back().plausible_lower = p.plausible_lower;
      list.back().plausible_upper = p.plausible_upper;
      list.back().neutral = p.neutral;
    }
  }
}

}  // namespace

double ModelParameter::get(const Model& model) const {
  if (shaft != ShaftNumber::none) return shaft_value(model, shaft);
  const std::vector<double>& values =
      effect < 0 ? model.law_values : model.effects.at(static_cast<std::size_t>(effect)).values;
  return values.at(index);
}

void ModelParameter::set(Model& model, double value) const {
  if (shaft != ShaftNumber::none) return set_shaft_value(model, shaft, value);
  std::vector<double>& values =
      effect < 0 ? model.law_values : model.effects.at(static_cast<std::size_t>(effect)).values;
  values.at(index) = value;
}

std::vector<ModelParameter> model_parameters(const Model& model) {
  std::vector<ModelParameter> list;
  append(list, friction::parameters(model.law), "", -1);
  for (const ShaftParameter& p : shaft_parameters(model))
    list.push_back({.name = std::string(p.name),
                    .unit = std::string(p.unit),
                    .initial = shaft_value(model, p.number),
                    .lower = p.lower,
                    .upper = p.upper,
                    .shaft = p.number});
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    const effects::Description& description = *model.effects[k].description;
    append(list, description.parameters, std::string(description.id) + ".", static_cast<int>(k));
  }
  return list;
}

std::vector<ModelParameter> free_parameters(const Model& model) {
  const std::vector<ModelParameter> known = model_parameters(model);
  const std::vector<std::string> names = model.free.empty() ? default_free(model) : model.free;
  std::vector<ModelParameter> list;
  for (const std::string& name : names) {
    const auto same = [&](const ModelParameter& p) { return p.name == name; };
    if (std::any_of(list.begin(), list.end(), same))
      throw std::invalid_argument("free parameter \"" + name + "\" is listed twice");
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found == known.end()) throw std::invalid_argument(unknown_name(name, known));
    list.push_back(*found);
  }
  const auto has = [&](ShaftNumber number) {
    return std::any_of(list.begin(), list.end(),
                       [&](const ModelParameter& p) { return p.shaft == number; });
  };
  if (has(ShaftNumber::conformity) &&
      (has(ShaftNumber::inner_conformity) || has(ShaftNumber::outer_conformity)))
    throw std::invalid_argument(
        "free parameter \"conformity\" is that of both grooves: leave out inner_conformity and "
        "outer_conformity, or conformity");
  return list;
}

std::vector<std::string> default_free(friction::FrictionLaw law) {
  if (law == friction::FrictionLaw::palmgren) return {"f0", "z"};
  return {"mu_EHL", "K_rs"};
}

std::vector<std::string> default_free(const Model& model) {
  for (const ShaftParameter& p : shaft_parameters(model))
    if (p.number == ShaftNumber::preload) return {std::string(p.name)};
  return default_free(model.law);
}

}  // namespace raceway::fit
