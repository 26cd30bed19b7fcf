#include "files/model_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "files/catalogue_file.h"
#include "text/csv.h"
#include "text/input_file.h"
#include "text/names.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/bearing_estimate.h"
#include "files/detail/bearing_section.h"
#include "files/detail/model_reader.h"

namespace raceway::files {
namespace {

/// Tables of which no prediction is made.
constexpr std::array<std::string_view, 6> not_predicting{"calibration",   "columns",    "loop",
                                                         "torque_sensor", "correction", "solver"};
/// Those of them that need not be read again.
constexpr std::array<std::string_view, 4> left_out{"calibration", "columns", "loop",
                                                   "torque_sensor"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// "shaft.segment.2.length_mm" step by step.
using Path = std::vector<std::string>;

bool is_place(std::string_view step) {
  return !step.empty() && step.find_first_not_of("0123456789") == step.npos;
}

std::size_t index_of(std::string_view step) {
  std::size_t index = 0;
  std::from_chars(step.data(), step.data() + step.size(), index);
  return index;
}

bool is_count(std::string_view key) {
  return key == "ball_count" || key == "roller_count" || key == "bearings";
}

/// How many bearings a set has.
bool is_choice(const Path& path) {
  return path.size() == 2 && path[0] == "arrangement" && (path[1] == "front" || path[1] == "rear");
}

struct Leaf {
  Path path;
  double value;
};

/// All numbers below a node, in the order of its text.
void collect(const toml::node& node, Path& path, std::vector<Leaf>& leaves) {
  if (node.is_number()) {
    leaves.push_back({path, *node.value<double>()});
    return;
  }
  const auto below = [&](std::string step, const toml::node& child) {
    path.push_back(std::move(step));
    collect(child, path, leaves);
    path.pop_back();
  };
  if (const toml::array* const array = node.as_array())
    for (std::size_t k = 0; k < array->size(); ++k) below(std::to_string(k), *array->get(k));
  const toml::table* const table = node.as_table();
  if (!table) return;
  std::vector<std::pair<std::string, const toml::node*>> children;
  for (const auto& [key, child] : *table) children.emplace_back(key.str(), &child);
  std::stable_sort(children.begin(), children.end(), [](const auto& a, const auto& b) {
    const auto x = a.second->source().begin, y = b.second->source().begin;
    return x.line != y.line ? x.line < y.line : x.column < y.column;
  });
  for (const auto& [key, child] : children) below(key, *child);
}

/// A default by its path; nothing where it is no number of its own.
std::optional<Leaf> number_of_default(const UsedDefault& one) {
  if (one.origin == UsedDefault::Origin::derived || one.origin == UsedDefault::Origin::marked)
    return std::nullopt;
  Leaf leaf{.path = {}, .value = unset};
  const char* const last = one.value.data() + one.value.size();
  const auto [end, error] = std::from_chars(one.value.data(), last, leaf.value);
  if (error != std::errc() || end != last) return std::nullopt;
  // effect[0] is written effect.0 in names.
  if (one.table.find('.') != one.table.npos) return std::nullopt;
  if (const std::size_t at = one.table.find('['); at != one.table.npos)
    leaf.path = {one.table.substr(0, at), one.table.substr(at + 1, one.table.size() - at - 2)};
  else
    leaf.path = {one.table};
  leaf.path.emplace_back(one.key);
  return leaf;
}

/// The table that holds the last step of a path, made where it is a table of its own that nobody
/// wrote; null where it is a list.
toml::node* holder(toml::table& root, const Path& path) {
  toml::node* node = &root;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (toml::table* const table = node->as_table()) {
      if (!table->get(path[k])) table->insert(path[k], toml::table{});
      node = table->get(path[k]);
    } else {
      node = node->as_array()->get(index_of(path[k]));
    }
  }
  return node;
}

void put(toml::table& root, const Path& path, double value) {
  toml::node* const node = holder(root, path);
  if (toml::array* const array = node->as_array()) {
    array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(index_of(path.back())), value);
    return;
  }
  toml::table& table = *node->as_table();
  // A parameter of a user's own effect is a table with a value.
  toml::node* const old = table.get(path.back());
  if (old && old->is_table())
    old->as_table()->insert_or_assign("value", value);
  else if (toml::value<double>* const number = old ? old->as_floating_point() : nullptr)
    *number = value;  // keeps its line, for messages
  else
    table.insert_or_assign(path.back(), value);
}

/// Of an effect by its id, where no other has it.
std::string name_of(const Path& path, const std::vector<std::string>& effects) {
  if (path.size() > 2 && path[0] == "effect" && is_place(path[1])) {
    const std::string& id = effects.at(index_of(path[1]));
    if (!id.empty() && std::count(effects.begin(), effects.end(), id) == 1)
      return fmt::format("{}.{}", id, fmt::join(path.begin() + 2, path.end(), "."));
  }
  return fmt::format("{}", fmt::join(path, "."));
}

/// True of a number, or of a list of them, that the file marks as a guess.
bool is_marked(const std::vector<UsedDefault>& defaults, const Path& path) {
  const std::string name = fmt::format("{}.", fmt::join(path, "."));
  return std::any_of(defaults.begin(), defaults.end(), [&](const UsedDefault& one) {
    if (one.origin != UsedDefault::Origin::marked) return false;
    // segment[0] is written segment.0 in names.
    std::string marked = fmt::format("{}.{}.", one.table, one.key);
    std::replace(marked.begin(), marked.end(), '[', '.');
    std::erase(marked, ']');
    return name.starts_with(marked);
  });
}

std::vector<std::string> ids_of_effects(const toml::table& root) {
  std::vector<std::string> ids;
  if (const toml::array* const list = root["effect"].as_array())
    for (const toml::node& one : *list)
      ids.push_back(one.is_table() ? (*one.as_table())["id"].value_or(std::string()) : "");
  return ids;
}

/// Of a user's own effect the value alone: neither its bounds nor what stands in a table of one.
bool is_bound_of_effect(Path& path) {
  if (path.size() != 4 || path[0] != "effect") return false;
  if (path.back() != "value") return true;
  path.pop_back();
  return false;
}

}  // namespace

struct ModelData::Tables {
  toml::table root;
  std::string source, text;
  std::vector<Path> paths;  // of the data
};

ModelData::ModelData(const ModelFile& file) {
  auto tables = std::make_shared<Tables>();
  std::string_view text = file.text;
  if (text.starts_with(text::utf8_mark)) text.remove_prefix(text::utf8_mark.size());
  tables->root = text::parse_toml(text, file.source);
  tables->source = file.source;
  tables->text = file.text;
  toml::table& root = tables->root;
  std::vector<std::pair<Leaf, ModelDatum::Origin>> found;
  std::vector<Leaf> leaves;
  Path path;
  collect(root, path, leaves);
  for (Leaf& leaf : leaves) found.emplace_back(std::move(leaf), ModelDatum::Origin::file);
  const auto is_known = [&](const Path& p) {
    return std::any_of(found.begin(), found.end(),
                       [&](const auto& f) { return f.first.path == p; });
  };
  if (!file.catalogue.empty()) {
    bearing::BearingGeometry geometry =
        bearing_called(file.catalogue, read_catalogues()).row.geometry;
    // Of ceramic balls it is another one.
    geometry.static_load_rating = file.model.shaft && file.model.shaft->own_bearings
                                      ? geometry.static_load_rating
                                      : file.model.bearing.static_load_rating();
    const bool other_sizes =
        is_known({"bearing", "ball_diameter_mm"}) || is_known({"bearing", "pitch_diameter_mm"});
    for (const auto& [key, value] : keys_of(geometry)) {
      Leaf leaf{.path = {"bearing", key}, .value = value};
      // Bore and outer diameter of the catalogue hold for its own sizes alone.
      const bool follows = other_sizes && (key == "bore_mm" || key == "outer_diameter_mm");
      if (is_known(leaf.path) || follows) continue;
      put(root, leaf.path, value);
      found.emplace_back(std::move(leaf), ModelDatum::Origin::catalogue);
    }
  }
  for (const UsedDefault& one : file.defaults)
    if (std::optional<Leaf> leaf = number_of_default(one); leaf && !is_known(leaf->path))
      found.emplace_back(*std::move(leaf), one.origin == UsedDefault::Origin::key
                                               ? ModelDatum::Origin::by_default
                                               : ModelDatum::Origin::catalogue);
  const std::vector<std::string> effects = ids_of_effects(root);
  for (auto& [leaf, origin] : found) {
    Path& at = leaf.path;
    const bool marked = is_marked(file.defaults, at);
    if (is_one_of(not_predicting, at.front()) || is_choice(at) || is_bound_of_effect(at)) continue;
    data_.push_back({.name = name_of(at, effects),
                     .value = leaf.value,
                     .origin = origin,
                     .whole = is_count(at.back()),
                     .marked = marked});
    tables->paths.push_back(std::move(at));
  }
  for (const std::string_view name : left_out) root.erase(name);
  tables_ = std::move(tables);
}

std::size_t ModelData::find(std::string_view name) const {
  std::vector<std::size_t> same_key;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < data_.size(); ++k) {
    if (data_[k].name == name) return k;
    names.push_back(data_[k].name);
    if (data_[k].name.ends_with(fmt::format(".{}", name))) same_key.push_back(k);
  }
  if (same_key.size() == 1) return same_key.front();
  const std::string key(name);
  if (same_key.empty()) {
    std::vector<std::string> short_names = names;
    for (const std::string& one : names) short_names.push_back(one.substr(one.rfind('.') + 1));
    const std::string near = text::suggestion(name, short_names);
    throw text::InputError(fmt::format("{}: {} has no number of this name{}", name, tables_->source,
                                       near.empty() ? "; it has " + text::listed(names) : near),
                           {.file = tables_->source, .key = key});
  }
  std::vector<std::string> all;
  for (const std::size_t k : same_key) all.push_back(names[k]);
  throw text::InputError(
      fmt::format("{}: {} has several numbers of this name; name one of these: {}", name,
                  tables_->source, text::listed(all)),
      {.file = tables_->source, .key = key});
}

ModelFile ModelData::with(std::span<const std::pair<std::size_t, double>> changes) const {
  ModelTables tables(
      [&] {
        toml::table root = tables_->root;
        for (const auto& [index, value] : changes) put(root, tables_->paths.at(index), value);
        return root;
      }(),
      tables_->source);
  return model_of_tables(tables, tables_->text);
}

std::vector<SpreadText> parse_spreads(const std::string& list) {
  std::vector<SpreadText> spreads;
  for (const std::string_view part : text::split(list, ',')) {
    const std::string one(part);
    const std::size_t equals = one.find('=');
    if (equals == one.npos || equals == 0 || equals + 1 == one.size())
      throw text::InputError(fmt::format("{}: write a number of the model and its possible error, "
                                         "such as ball_diameter_mm=0.01 or viscosity_40C_mm2_s=10%",
                                         text::quoted(one)),
                             {.key = one.substr(0, equals)});
    spreads.push_back({.name = one.substr(0, equals), .text = one.substr(equals + 1)});
  }
  return spreads;
}

std::vector<SpreadText> read_spreads(const std::string& path) {
  const toml::table root = text::parse_toml(text::read_text(path), text::input_name(path));
  std::vector<SpreadText> spreads;
  std::vector<std::string> step;
  const auto look = [&](const auto& again, const toml::node& node) -> void {
    const std::string name = fmt::format("{}", fmt::join(step, "."));
    if (const toml::table* const table = node.as_table()) {
      for (const auto& [key, child] : *table) {
        step.emplace_back(key.str());
        again(again, child);
        step.pop_back();
      }
    } else if (const toml::array* const array = node.as_array()) {
      for (std::size_t k = 0; k < array->size(); ++k) {
        step.push_back(std::to_string(k));
        again(again, *array->get(k));
        step.pop_back();
      }
    } else if (node.is_number()) {
      spreads.push_back({.name = name, .text = fmt::format("{}", *node.value<double>())});
    } else if (node.is_string()) {
      spreads.push_back({.name = name, .text = *node.value<std::string>()});
    } else {
      throw text::InputError(
          fmt::format("{}:{}: {} = {}: must be a number, or a text such as \"10%\"",
                      text::input_name(path), node.source().begin.line, name, text::shown(node)),
          {.file = path, .line = static_cast<int>(node.source().begin.line), .key = name});
    }
  };
  look(look, root);
  return spreads;
}

double spread_of(const SpreadText& spread, double value) {
  std::string_view text = spread.text;
  for (const std::string_view sign : {"\xc2\xb1", "+-", "+"})  // ±
    if (text.starts_with(sign)) {
      text.remove_prefix(sign.size());
      break;
    }
  const auto refuse = [&](const std::string& why) {
    throw text::InputError(fmt::format("spread of {} = {}: {}", spread.name, spread.text, why),
                           {.key = spread.name});
  };
  const bool share = text.ends_with("%");
  std::string_view digits = share ? text.substr(0, text.size() - 1) : text;
  while (digits.ends_with(' ')) digits.remove_suffix(1);
  while (digits.starts_with(' ')) digits.remove_prefix(1);
  double number = unset;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(number))
    refuse("must be a number in the unit of the value, or a percentage such as 10%");
  if (number < 0.0)
    refuse("must be 0 or more, because it is the possible error in both directions");
  if (share && value == 0.0)
    refuse(
        "the value is 0, so a percentage has no effect; give the error in the unit of the value");
  return share ? 0.01 * number * std::fabs(value) : number;
}

}  // namespace raceway::files
