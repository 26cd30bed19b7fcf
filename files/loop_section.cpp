#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

#include "correction/numbers.h"
#include "files/subject.h"
#include "model/parameters.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/loop_section.h"
#include "files/detail/number_lists.h"

namespace raceway::files {
namespace {

constexpr Key calibration_keys[]{
    {"free", a_list, "usual free parameters of the law",
     "parameters to fit: parameters of the law, preload_N, inner_conformity, outer_conformity, "
     "conformity, contact_angle_deg, or \"EFFECT.PARAMETER\" for a parameter of an effect; for a "
     "correction: its parameters or groups of parameters"},
    {"covariance", a_table, unset,
     "covariance of the fitted parameters, table [calibration.covariance]"},
};
constexpr Key loop_keys[]{
    {"tolerance_Nmm", between(0, 1e9, "Nmm"), unset,
     "largest RMS error of the friction torque that you accept; above 0"},
    {"tolerance_um", between(0, 1e9, "um"), unset,
     "largest RMS error of the displacement that you accept; above 0"},
    {"tolerance_urad", between(0, 1e9, "urad"), unset,
     "for corrections: largest RMS error of an angle that you accept; above 0"},
    {"tolerance_K", between(0, 1e9, "K"), unset,
     "for spindles: largest RMS error of a temperature that you accept; above 0"},
};

/// Full names by every name that a parameter may be called: that of an effect is "id.name", and
/// `name` alone where no other has it. A full name is never the short name of another parameter.
std::multimap<std::string, std::string> full_names(const model::Model& model) {
  std::multimap<std::string, std::string> names, short_names;
  for (const record::Parameter& p : model::parameters(model)) {
    names.emplace(p.name, p.name);
    if (const std::size_t dot = p.name.find('.'); dot != p.name.npos)
      short_names.emplace(p.name.substr(dot + 1), p.name);
  }
  std::erase_if(short_names, [&](const auto& name) { return names.contains(name.first); });
  names.merge(short_names);
  return names;
}

/// Says which key a number of a spindle needs before a fit can change it; empty for another name.
std::string no_start_of(const model::Model& model, const std::string& name) {
  if (!model.spindle) return {};
  if (name == "outer_conductance_W_m2K")
    return "the model has no such value, because it calculates this conductance from the fit of "
           "the rings in the housing; give a start value under [seat]";
  for (const model::Circuit& circuit : model.spindle->circuits)
    if (name == circuit.name + ".inlet_temperature_C")
      return "this circuit uses the inlet temperature of [coolant]; give a start value under its "
             "[[coolant.circuit]]";
  return {};
}

std::string list_of(const Names& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
  return "[" + text + "]";
}

Names default_names(ModelTables& tables, const model::Model& model) {
  Names names = model::default_free(model);
  std::string text = list_of(names);
  if (const Names of_torque = model::default_free(model.law);
      model.shaft && !model.spindle && names != of_torque)
    text += fmt::format(" (to fit a displacement; to fit a torque: {})", list_of(of_torque));
  tables.note_default("calibration", "free", text);
  return names;
}

Names words_of(const std::vector<fit::Measured>& measured) {
  Names words;
  for (const fit::Measured& m : measured) words.emplace_back(m.channel->words);
  return words;
}

/// A list of parameters, by full name. `of_others`: names that are for another reader.
Names names_in(const Section& s, std::string_view key, const toml::node& node,
               const model::Model& model,
               const std::function<bool(const std::string&)>& of_others = {}) {
  const auto wrong = [&](const toml::node& at, const std::string& problem) {
    throw text::InputError(
        fmt::format("{}: {} = {}: {}", s.place(&at), key, text::shown(at), problem),
        s.at(key, &at));
  };
  if (!node.is_array() || node.as_array()->empty())
    wrong(node, "must be a list of at least one name, such as [\"f0\", \"z\"]");
  const std::multimap<std::string, std::string> known = full_names(model);
  Names names;
  for (const toml::node& entry : *node.as_array()) {
    const auto name = entry.is_string() ? entry.value<std::string>() : std::nullopt;
    if (!name) wrong(entry, "must be the name of a parameter in quotes");
    if (of_others && of_others(*name)) continue;
    const auto [first, last] = known.equal_range(*name);
    if (first == last) {
      Names all;
      for (const auto& [called, _] : known) all.push_back(called);
      if (const std::string why = no_start_of(model, *name); !why.empty()) wrong(entry, why);
      const std::string near = text::suggestion(*name, all);
      wrong(entry,
            "no such parameter" + (near.empty() ? "; this model has " + text::listed(all) : near));
    }
    if (std::next(first) != last)
      wrong(entry,
            "several effects have a parameter of this name; put the id of one effect before the "
            "name: EFFECT." +
                *name);
    if (std::find(names.begin(), names.end(), first->second) != names.end())
      wrong(entry, "is given twice");
    names.push_back(first->second);
  }
  return names;
}

/// [calibration.covariance] of some parameters, checked key by key.
class CovarianceReader {
 public:
  CovarianceReader(const Section& section, const model::Model& model)
      : s_(section), model_(model), known_(model::parameters(model)) {}

  fit::Covariance read() {
    fit::Covariance c;
    c.names = names_in(s_, "parameters", required_node(s_, "parameters"), model_);
    count_ = c.names.size();
    check_units(c.names);
    const std::vector<double> values = numbers(s_, "values", required_node(s_, "values"), count_);
    c.values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(count_));
    c.matrix = covariance_of(s_, count_);
    return c;
  }

 private:
  void check_units(const Names& names) const {
    const toml::node& node = required_node(s_, "units");
    const toml::array* const list = node.as_array();
    if (!list || list->size() != names.size()) fail_count(s_, "units", node, names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto p = std::find_if(known_.begin(), known_.end(),
                                  [&](const auto& one) { return one.name == names[k]; });
      if (list->get(k)->value<std::string>() != p->unit)
        throw text::InputError(
            fmt::format("{}: units = {}: the unit of {} must be \"{}\"", s_.place(list->get(k)),
                        text::shown(*list->get(k)), names[k], p->unit),
            s_.at("units", list->get(k)));
    }
  }

  const Section& s_;
  const model::Model& model_;
  std::vector<record::Parameter> known_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<KeyTable> loop_tables() {
  return {{"calibration", calibration_keys},
          {"calibration.covariance", covariance_keys},
          {"loop", loop_keys}};
}

Section loop_section(const ModelTables& tables) { return tables.section("loop", {loop_keys}); }
Section calibration_section(const ModelTables& tables) {
  return tables.section("calibration", {calibration_keys});
}

Names read_free(ModelTables& tables, const model::Model& model) {
  const Section s = calibration_section(tables);
  const toml::node* const node = s.find("free");
  if (!node) return default_names(tables, model);
  if (!tables.root().contains("correction") || !node->is_array())
    return names_in(s, "free", *node, model);
  // The list is of the correction as well.
  std::vector<std::string> known;
  for (const record::Parameter& p : model::parameters(model)) known.push_back(p.name);
  Names names = names_in(s, "free", *node, model, [&](const std::string& name) {
    return correction::is_group(name) ||
           (name.find('.') != name.npos &&
            std::find(known.begin(), known.end(), name) == known.end());
  });
  return names.empty() ? default_names(tables, model) : names;
}

std::optional<fit::Covariance> read_covariance(const ModelTables& tables,
                                               const model::Model& model) {
  const Section calibration = tables.section("calibration");
  const toml::node* const node = calibration.find("covariance");
  if (!node) return std::nullopt;
  if (!node->is_table())
    calibration.fail("covariance", fmt::format("covariance = {}: must be a table, written as "
                                               "[calibration.covariance]",
                                               text::shown(*node)));
  const Section s(tables.source(), "calibration.covariance", node->as_table(), {covariance_keys});
  return CovarianceReader(s, model).read();
}

std::string other_values(const fit::Covariance& covariance, const model::Model& model) {
  constexpr double same = 1e-9;
  const std::vector<record::Parameter> known = model::parameters(model);
  for (std::size_t k = 0; k < covariance.names.size(); ++k)
    for (const record::Parameter& p : known)
      if (const double value = covariance.values[static_cast<Eigen::Index>(k)];
          p.name == covariance.names[k] &&
          !(std::abs(p.value - value) <= same * std::max(std::abs(p.value), std::abs(value))))
        return fmt::format(
            "the model has {0} = {1:.6g}, but [calibration.covariance] was calculated for {0} = "
            "{2:.6g}",
            p.name, p.value, value);
  return {};
}

std::vector<record::NamedValue> read_tolerances(const ModelTables& tables,
                                                const model::Model& model) {
  const Section s = loop_section(tables);
  if (!s.given()) return {};
  const std::vector<fit::Measured> measured = measurable(model);
  std::vector<record::NamedValue> tolerances;
  for (const Key& key : loop_keys) {
    const auto value = s.number(key);
    if (!value) continue;
    const std::string_view name = key.name, unit = key.form.unit;
    if (*value == 0.0) s.fail(name, fmt::format("{} = 0 {}: must be above 0", name, unit));
    const std::size_t before = tolerances.size();
    for (const fit::Measured& m : measured)
      if (text::tolerance_key(*m.channel) == name)
        tolerances.push_back({std::string(m.channel->name), *value * m.channel->factor});
    if (tolerances.size() == before)
      s.fail(name, fmt::format("{} = {}: this model predicts {}, but no quantity in {}", name,
                               *value, text::listed(words_of(measured)), unit));
  }
  return tolerances;
}

}  // namespace raceway::files
