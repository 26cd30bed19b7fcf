#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "files/model_file.h"
#include "model/corrected_data.h"
#include "model/parameters.h"
#include "record/digits.h"
#include "text/error.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/marked_values.h"
#include "text/detail/toml_text.h"

// Changes a model file and leaves all else as the user wrote it.
namespace raceway::files {
namespace {

/// "effect.0.f" as {"effect" with its index 0} and "f".
struct KeyPath {
  struct Step {
    std::string name;
    std::optional<std::size_t> index = {};  ///< into a list of tables
  };
  std::vector<Step> tables;
  std::string key;
};

bool is_index(std::string_view text) {
  return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == text.npos;
}

KeyPath parse_path(const std::string& text) {
  KeyPath path;
  std::size_t begin = 0;
  for (std::size_t dot; (dot = text.find('.', begin)) != text.npos; begin = dot + 1) {
    const std::string step = text.substr(begin, dot - begin);
    if (!path.tables.empty() && !path.tables.back().index && is_index(step))
      path.tables.back().index = std::stoul(step);
    else
      path.tables.push_back({step});
  }
  path.key = text.substr(begin);
  return path;
}

const toml::table* find_table(const toml::table& root, const KeyPath& path) {
  const toml::table* table = &root;
  for (const KeyPath::Step& step : path.tables) {
    const toml::node* node = table->get(step.name);
    if (node && step.index) node = node->is_array() ? node->as_array()->get(*step.index) : nullptr;
    table = node ? node->as_table() : nullptr;
    if (!table) return nullptr;
  }
  return table;
}

std::string_view line_end_of(std::string_view text) {
  return text.find("\r\n") != text.npos ? "\r\n" : "\n";
}

/// The number of a key; a parameter of a user's own effect is a table with a value. Null where
/// there is no key.
const toml::node* find_number(const toml::table& table, const KeyPath& path) {
  const toml::node* const node = table.get(path.key);
  return node && node->is_table() ? node->as_table()->get("value") : node;
}

std::string with_new_table(std::string text, const KeyPath& path, const std::string& assignment) {
  const std::string line_end(line_end_of(text));
  if (!text.empty() && text.back() != '\n') text += line_end;
  return fmt::format("{}{}[{}]{}{}{}", text, line_end, path.tables[0].name, line_end, assignment,
                     line_end);
}

/// The key of a table that stands last in it, with its value; null where it has none.
std::pair<const toml::key*, const toml::node*> last_of(const toml::table& table) {
  const auto ends_before = [](const toml::node& a, const toml::node& b) {
    const auto x = a.source().end, y = b.source().end;
    return x.line != y.line ? x.line < y.line : x.column < y.column;
  };
  std::pair<const toml::key*, const toml::node*> last{};
  for (const auto& [key, node] : table) {
    const bool elsewhere =
        (node.is_table() && !node.as_table()->is_inline()) || node.is_array_of_tables();
    if (!elsewhere && !(last.second && ends_before(node, *last.second))) last = {&key, &node};
  }
  return last;
}

/// A new key goes behind the last one of its table, written as that one is.
std::string with_new_key(std::string text, const toml::table& table,
                         const std::string& assignment) {
  const auto [last_key, last] = last_of(table);
  if (table.is_inline()) {
    if (last) return text.insert(text::byte_of(text, last->source().end), ", " + assignment);
    return text.insert(text::byte_of(text, table.source().begin) + 1, " " + assignment + " ");
  }
  const std::string line_end(line_end_of(text));
  const std::size_t line = last ? last->source().end.line : table.source().begin.line;
  std::string before;
  if (last) {
    const std::size_t begin = text::line_start(text, last_key->source().begin.line);
    before = text.substr(begin, text::byte_of(text, last_key->source().begin) - begin);
  }
  std::size_t at = text.find('\n', text::line_start(text, line));
  if (at == text.npos) {
    text += line_end;
    at = text.size();
  } else {
    ++at;
  }
  return text.insert(at, before + assignment + line_end);
}

std::string with_value(std::string text, const KeyValue& change) {
  const std::string value = text::toml_float(change.value);
  const KeyPath path = parse_path(change.key);
  const toml::table root = text::parse_toml(text, "model");
  const toml::table* const table = find_table(root, path);
  const std::string assignment = fmt::format("{} = {}", path.key, value);
  if (!table) {
    if (path.tables.size() != 1 || path.tables[0].index)
      throw text::InputError(fmt::format("{}: the model has no table of this name", change.key),
                             {.key = change.key});
    return with_new_table(std::move(text), path, assignment);
  }
  if (!table->get(path.key)) return with_new_key(std::move(text), *table, assignment);
  const toml::node* const node = find_number(*table, path);
  if (!node || !node->is_number())
    throw text::InputError(fmt::format("{} = {}: the value in the model must be a number",
                                       change.key, text::shown(*table->get(path.key))),
                           {.key = change.key});
  const std::size_t begin = text::byte_of(text, node->source().begin);
  text.replace(begin, text::byte_of(text, node->source().end) - begin, value);
  return without_mark(std::move(text), begin + value.size());
}

/// Writes the comment of a change whose value stands already.
std::string with_comment(std::string text, const KeyValue& change) {
  const KeyPath path = parse_path(change.key);
  const toml::table root = text::parse_toml(text, "model");
  const toml::table* const table = find_table(root, path);
  if (change.comment.empty() || !table || table->is_inline()) return text;
  const std::size_t value_end = text::byte_of(text, table->get(path.key)->source().end);
  std::size_t end = std::min(text.find('\n', value_end), text.size());
  if (end > value_end && text[end - 1] == '\r') --end;
  const std::size_t old = text.find('#', value_end);
  // Comments that stand in one column stay there.
  const std::size_t blanks = old < end ? std::max<std::size_t>(1, old - value_end) : 2;
  return text.replace(value_end, end - value_end, std::string(blanks, ' ') + "# " + change.comment);
}

}  // namespace

std::string with_values(std::string_view text, std::span<const KeyValue> changes) {
  const bool marked = text.starts_with(text::utf8_mark);
  if (marked) text.remove_prefix(text::utf8_mark.size());
  std::string result(text);
  for (const KeyValue& change : changes) {
    if (!std::isfinite(change.value))
      throw std::invalid_argument(fmt::format("{} = {}: must be finite", change.key, change.value));
    result = with_comment(with_value(std::move(result), change), change);
  }
  const toml::table root = text::parse_toml(result, "model");
  for (const KeyValue& change : changes) {
    const KeyPath path = parse_path(change.key);
    const toml::table* const table = find_table(root, path);
    const toml::node* const node = table ? find_number(*table, path) : nullptr;
    if (!node || node->value<double>() != change.value)
      throw text::InputError(
          fmt::format("{}: the key was not found in the text of the model", change.key),
          {.key = change.key});
  }
  if (marked) result.insert(0, text::utf8_mark);
  return result;
}

std::string with_effect(std::string_view text, const effects::Effect& effect) {
  const std::string_view line_end = line_end_of(text);
  std::string result(text);
  if (!result.empty() && result.back() != '\n') result += line_end;
  const effects::Description& d = *effect.description;
  result += fmt::format("{}[[effect]]{}id = \"{}\"{}", line_end, line_end, d.id, line_end);
  if (d.user_made) result += fmt::format("torque_Nmm = \"{}\"{}", d.formula, line_end);
  for (std::size_t k = 0; k < d.parameters.size(); ++k) {
    const effects::Parameter& p = d.parameters[k];
    if (!std::isfinite(effect.values.at(k)))
      throw std::invalid_argument(
          fmt::format("{}.{} = {}: must be finite", d.id, p.name, effect.values[k]));
    const std::string value = text::toml_float(effect.values[k]);
    if (!d.user_made) {
      result += fmt::format("{} = {}{}", p.name, value, line_end);
      continue;
    }
    result += fmt::format("{} = {{ value = {}, unit = \"{}\"", p.name, value, p.unit);
    if (std::isfinite(p.lower)) result += fmt::format(", lower = {}", text::toml_float(p.lower));
    if (std::isfinite(p.upper)) result += fmt::format(", upper = {}", text::toml_float(p.upper));
    result += fmt::format(" }}{}", line_end);
  }
  return result;
}

namespace {

/// What stands otherwise in a model than in its file, but for what model::parameters() has: the
/// oil card, and the room that a correction of the temperature was found with.
std::vector<KeyValue> changed_data(const ModelFile& written, const model::Model& fitted) {
  const model::Model& file = written.model;
  std::vector<KeyValue> changes;
  const auto add = [&](std::string key, double before, double after, std::string comment) {
    if (before != after && !std::isnan(after))
      changes.push_back({std::move(key), text::with_15_digits(after), std::move(comment)});
  };
  const friction::Lubricant &card = file.lubricant, &oil = fitted.lubricant;
  // A guess that was fitted is still no data sheet: the next fit may change it again.
  const auto add_viscosity = [&](const std::string& key, double before, double after) {
    const bool guessed =
        std::any_of(written.defaults.begin(), written.defaults.end(), [&](const UsedDefault& d) {
          return d.origin == UsedDefault::Origin::marked && d.table == "lubricant" && d.key == key;
        });
    add("lubricant." + key, before / mm2_per_s, after / mm2_per_s,
        fmt::format("{}corrected by measurements; entered value: {:.6g}",
                    guessed ? "assumed; " : "", before / mm2_per_s));
  };
  add_viscosity("viscosity_40C_mm2_s", card.viscosity_40C(), oil.viscosity_40C());
  add_viscosity("viscosity_100C_mm2_s", card.viscosity_100C(), oil.viscosity_100C());
  const bool needs_room =
      std::any_of(fitted.effects.begin(), fitted.effects.end(),
                  [](const effects::Effect& e) { return e.description->uses_room; });
  if (needs_room && std::isnan(file.rig.room_temperature))
    add("rig.room_temperature_C", unset, celsius(fitted.rig.room_temperature),
        "temperature of the coldest row of the record");
  return changes;
}

}  // namespace

namespace {

/// The text without the table [calibration.covariance], where it has one.
std::string without_covariance(std::string text) {
  const toml::table root = text::parse_toml(text, "model");
  const toml::table* const table = root["calibration"]["covariance"].as_table();
  if (!table) return text;
  const auto [last_key, last] = last_of(*table);
  const std::size_t begin = text::line_start(text, table->source().begin.line);
  if (table->is_inline() || text.find_first_not_of(" \t", begin) != text.find('[', begin))
    throw text::InputError(
        "the covariance under [calibration] is an inline table in braces: write it as a table "
        "[calibration.covariance], or remove it",
        {.key = "calibration.covariance"});
  std::size_t end =
      text.find('\n', text::line_start(text, (last ? last : table)->source().end.line));
  end = end == text.npos ? text.size() : end + 1;
  text.erase(begin, end - begin);
  // Nor the blank line before it.
  const std::string line_end(line_end_of(text));
  if (begin >= 2 * line_end.size() &&
      std::string_view(text).substr(0, begin).ends_with(line_end + line_end))
    text.erase(begin - line_end.size(), line_end.size());
  return text;
}

/// With [calibration.covariance] at the end.
std::string with_covariance(std::string text, const fit::Covariance& c,
                            const std::vector<record::Parameter>& parameters) {
  const std::string line_end(line_end_of(text));
  if (!text.empty() && text.back() != '\n') text += line_end;
  std::vector<std::string> names, units, values, std, rows;
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    const auto p = std::find_if(parameters.begin(), parameters.end(),
                                [&](const auto& one) { return one.name == c.names[k]; });
    if (p == parameters.end())
      throw std::invalid_argument(c.names[k] +
                                  ": the covariance has this parameter, but the model does not");
    names.push_back(fmt::format("\"{}\"", c.names[k]));
    units.push_back(fmt::format("\"{}\"", p->unit));
    values.push_back(
        text::toml_float(text::with_15_digits(c.values[static_cast<Eigen::Index>(k)])));
    std.push_back(text::toml_float(record::with_digits(c.std(k), 6)));
    std::vector<std::string> row;
    for (std::size_t j = 0; j <= k; ++j)
      row.push_back(text::toml_float(record::with_digits(c.correlation(k, j), 12)));
    rows.push_back(fmt::format("  [{}],", fmt::join(row, ", ")));
  }
  text += fmt::format(
      "{0}[calibration.covariance]  # covariance of the fitted parameters, for --band{0}",
      line_end);
  for (const auto& [key, list] :
       {std::pair{"parameters", &names}, {"units", &units}, {"values", &values}, {"std", &std}})
    text += fmt::format("{} = [{}]{}", key, fmt::join(*list, ", "), line_end);
  return text + fmt::format("correlation = [{0}{1}{0}]{0}", line_end, fmt::join(rows, line_end));
}

}  // namespace

namespace {

/// A table of a model and where it stands in its text.
const toml::table& table_to_edit(const toml::table& root, const std::string& name) {
  const toml::table* const table = root[name].as_table();
  if (table && !table->is_inline()) return *table;
  throw text::InputError(
      fmt::format("[{0}] is an inline table in braces: write it as a table [{0}] to change the law",
                  name),
      {.key = name});
}

/// The text with this value, as TOML writes it, for a key; a table that is not there is added.
std::string with_text_value(std::string text, const std::string& name, const std::string& key,
                            const std::string& value) {
  const toml::table root = text::parse_toml(text, "model");
  const KeyPath path{.tables = {{name}}, .key = key};
  const std::string assignment = fmt::format("{} = {}", key, value);
  if (!root.contains(name)) return with_new_table(std::move(text), path, assignment);
  const toml::table& table = table_to_edit(root, name);
  const toml::node* const node = table.get(key);
  if (!node) return with_new_key(std::move(text), table, assignment);
  const std::size_t begin = text::byte_of(text, node->source().begin);
  return text.replace(begin, text::byte_of(text, node->source().end) - begin, value);
}

/// The text without a key of a table, its line and the comment there.
std::string without_key(std::string text, const std::string& name, const std::string& key) {
  const toml::table root = text::parse_toml(text, "model");
  if (!root[name][key]) return text;
  const toml::table& table = table_to_edit(root, name);
  const std::size_t begin = text::line_start(text, table.find(key)->first.source().begin.line);
  const std::size_t value_end = text::byte_of(text, table.get(key)->source().end);
  const std::size_t end = text.find('\n', value_end);
  return text.erase(begin, (end == text.npos ? text.size() : end + 1) - begin);
}

/// The text with the law of a model, and with all numbers of that law.
std::string with_law(std::string text, const model::Model& before, const model::Model& fitted) {
  text = with_text_value(std::move(text), "friction", "law",
                         fmt::format("\"{}\"", friction::name(fitted.law)));
  text = with_comment(std::move(text),
                      {.key = "friction.law",
                       .value = 0.0,
                       .comment = fmt::format("it was \"{}\"", friction::name(before.law))});
  std::vector<KeyValue> numbers;
  for (std::size_t k = 0; const friction::Parameter& p : friction::parameters(fitted.law)) {
    if (!friction::of_the_lubricant(p))
      numbers.push_back(
          {fmt::format("friction.{}", p.name), text::with_15_digits(fitted.law_values[k])});
    ++k;
  }
  text = with_values(text, numbers);
  const std::span<const friction::Parameter> kept = friction::parameters(fitted.law);
  for (const friction::Parameter& p : friction::parameters(before.law)) {
    const bool stays = std::any_of(kept.begin(), kept.end(),
                                   [&](const friction::Parameter& k) { return k.name == p.name; });
    if (!friction::of_the_lubricant(p) && !stays)
      text = without_key(std::move(text), "friction", std::string(p.name));
  }
  if (!friction::of_rollers(fitted.law))
    for (const std::string_view key :
         {"f1_load", "inlet_over_b", "asperity_factor", "asperity_exponent"})
      text = without_key(text, "friction", std::string(key));
  if (before.balanced_balls && !fitted.balanced_balls)
    text = with_text_value(std::move(text), "solver", "race_control", "\"outer\"");
  std::vector<std::string> names;
  for (const std::string& name : fitted.free) names.push_back(fmt::format("\"{}\"", name));
  if (text::parse_toml(text, "model")["calibration"]["free"])
    text = with_text_value(std::move(text), "calibration", "free",
                           fmt::format("[{}]", fmt::join(names, ", ")));
  return text;
}

}  // namespace

std::string with_model(const ModelFile& file, const model::Model& found) {
  if (found.law != file.model.law) {
    ModelFile other = file;
    other.text =
        with_law(without_covariance(file.text), file.model, model::with_corrected_data(found));
    const bool marked = other.text.starts_with(text::utf8_mark);
    other = parse_model(marked ? other.text.substr(text::utf8_mark.size()) : std::move(other.text),
                        file.source, file.files);
    if (marked) other.text.insert(0, text::utf8_mark);
    return with_model(other, found);
  }
  const model::Model fitted = model::with_corrected_data(found);
  const auto in_file = [&](const effects::Effect& effect) {
    return std::any_of(
        file.model.effects.begin(), file.model.effects.end(),
        [&](const effects::Effect& e) { return e.description->id == effect.description->id; });
  };
  std::string text = without_covariance(file.text);
  for (effects::Effect effect : fitted.effects) {
    if (in_file(effect)) continue;
    for (double& value : effect.values) value = text::with_15_digits(value);
    text = with_effect(text, effect);
  }
  const std::vector<record::Parameter> written = model::parameters(file.model);
  std::vector<KeyValue> changes = changed_data(file, fitted);
  for (const record::Parameter& p : model::parameters(fitted)) {
    const auto old = std::find_if(written.begin(), written.end(),
                                  [&](const record::Parameter& w) { return w.name == p.name; });
    if (old == written.end() || old->value == p.value) continue;
    for (const std::string& address : old->addresses)
      changes.push_back({address, text::with_15_digits(p.value)});
  }
  text = with_values(text, changes);
  if (!found.covariance) return text;
  return with_covariance(std::move(text), *found.covariance, model::parameters(fitted));
}

}  // namespace raceway::files
