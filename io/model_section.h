#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.h"
#include "io/key_book.h"
#include "io/names.h"
#include "io/toml_text.h"

/// Tables of a model file and their keys; shared by the readers of model files, not for other code.
namespace raceway::io {

using Names = std::vector<std::string>;

/// A number of a model file with its unit and what it may be.
struct Key {
  std::string_view name;
  std::string_view unit;  ///< "" where dimensionless
  double lower, upper;    ///< closed, in `unit`
};

inline std::string with_unit(std::string_view number, std::string_view unit) {
  return unit.empty() || unit == "1" ? std::string(number) : fmt::format("{} {}", number, unit);
}

inline std::string range(const Key& key) {
  return fmt::format("must be from {} to {}", key.lower,
                     with_unit(fmt::format("{}", key.upper), key.unit));
}

inline std::string_view kind(const toml::node& node) {
  if (node.is_string()) return "a text";
  if (node.is_number()) return "a number";
  if (node.is_boolean()) return "true or false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

/// A key that must stand in the file and does not.
struct MissingKey : InputError {
  using InputError::InputError;
};

/// One table of the file. Asking for a value checks its type and range.
class Section {
 public:
  /// `table` may be null: then every key is absent.
  Section(std::string source, std::string name, const toml::table* table)
      : source_(std::move(source)), name_(std::move(name)), table_(table) {}

  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool given() const { return table_ != nullptr; }
  [[nodiscard]] const toml::table* table() const { return table_; }
  [[nodiscard]] const toml::node* find(std::string_view key) const {
    return table_ ? table_->get(key) : nullptr;
  }
  [[nodiscard]] std::string place(const toml::node* node = nullptr) const {
    if (!node) node = table_;
    return node ? fmt::format("{}:{}", source_, node->source().begin.line) : source_;
  }
  /// The place of a key, or of this table where the key is missing; `node` is a part of its value.
  [[nodiscard]] Place at(std::string_view key = {}, const toml::node* node = nullptr) const {
    if (!node && !key.empty()) node = find(key);
    if (!node) node = table_;
    return {.file = source_,
            .line = node ? static_cast<int>(node->source().begin.line) : 0,
            .key = std::string(key.empty() ? name_ : key)};
  }
  [[noreturn]] void fail(std::string_view key, const std::string& text) const {
    throw InputError(fmt::format("{}: {}", place(find(key)), text), at(key));
  }
  [[noreturn]] void fail_missing(const Key& key, const std::string& why = "") const {
    throw MissingKey(
        fmt::format("{}: [{}] {} is missing{}: {}", place(), name_, key.name, why, range(key)),
        at(key.name));
  }
  /// Those of the keys that are not there, each as "[bearing] ball_count: must be from 3 to 200".
  [[nodiscard]] Names lacking(const std::vector<Key>& keys) const {
    Names list;
    for (const Key& key : keys)
      if (!find(key.name)) list.push_back(fmt::format("[{}] {}: {}", name_, key.name, range(key)));
    return list;
  }

  void allow_only(const Names& known) const {
    if (KeyBook* const book = KeyBook::open())
      for (const std::string& name : known) book->entry(name_, name);
    if (!table_) return;
    for (const auto& [key, node] : *table_) {
      const std::string_view given = key.str();
      if (std::find(known.begin(), known.end(), given) != known.end()) continue;
      const std::string near = suggestion(given, known);
      throw InputError(
          fmt::format("{}:{}: {} = {}: unknown key in [{}]{}", source_, key.source().begin.line,
                      given, shown(node), name_, near.empty() ? "; it has " + listed(known) : near),
          {.file = source_,
           .line = static_cast<int>(key.source().begin.line),
           .key = std::string(given)});
    }
  }

  [[nodiscard]] std::optional<double> number(const Key& key) const {
    if (KeyBook* const book = KeyBook::open()) {
      ModelKey& entry = book->entry(name_, key.name);
      entry.unit = key.unit;
      entry.lower = key.lower;
      entry.upper = key.upper;
    }
    const toml::node* const node = find(key.name);
    if (!node) return std::nullopt;
    if (!node->is_number())
      fail(key.name, fmt::format("{} = {}: must be a number, not {}; {}", key.name, shown(*node),
                                 kind(*node), range(key)));
    const double value = *node->value<double>();
    if (!(value >= key.lower && value <= key.upper))
      fail(key.name,
           fmt::format("{} = {}: {}", key.name, with_unit(shown(*node), key.unit), range(key)));
    return value;
  }
  [[nodiscard]] double required(const Key& key) const {
    const auto value = number(key);
    if (KeyBook* const book = KeyBook::open()) book->entry(name_, key.name).required = true;
    if (!value) fail_missing(key);
    return *value;
  }
  [[nodiscard]] std::optional<int> whole_number(const Key& key) const {
    const auto value = number(key);
    if (KeyBook* const book = KeyBook::open()) book->entry(name_, key.name).whole = true;
    if (!value) return std::nullopt;
    if (*value != std::floor(*value))
      fail(key.name, fmt::format("{} = {}: must be a whole number from {} to {}", key.name, *value,
                                 key.lower, key.upper));
    return static_cast<int>(*value);
  }
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const {
    if (KeyBook* const book = KeyBook::open()) (void)book->entry(name_, key);
    const toml::node* const node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string())
      fail(key, fmt::format("{} = {}: must be a text in quotes, not {}", key, shown(*node),
                            kind(*node)));
    return *node->value<std::string>();
  }
  /// A text; empty for all else, a list among them.
  [[nodiscard]] std::string text_or_empty(std::string_view key) const {
    const toml::node* const node = find(key);
    return node && node->is_string() ? *node->value<std::string>() : std::string();
  }
  [[nodiscard]] std::optional<std::string> choice(std::string_view key,
                                                  const Names& allowed) const {
    if (KeyBook* const book = KeyBook::open()) book->entry(name_, key).choices = allowed;
    auto value = text(key);
    if (value && std::find(allowed.begin(), allowed.end(), *value) == allowed.end())
      fail(key, fmt::format("{} = \"{}\": must be {}{}", key, *value, listed(allowed, "or"),
                            suggestion(*value, allowed)));
    return value;
  }

  /// Puts the libraries' `ball_diameter = -12 mm: ...` into the words and the place of this file.
  [[noreturn]] void fail(const std::invalid_argument& error, const Names& known) const {
    std::string message = error.what();
    const std::string owner =
        name_.starts_with("material.") ? "material " + name_.substr(9) + ": " : "";
    if (!owner.empty() && message.starts_with(owner)) message.erase(0, owner.size());
    const std::string name = message.substr(0, message.find(' '));
    for (const std::string& key : known) {
      if (key != name && !key.starts_with(name + "_")) continue;
      const toml::node* node = find(key);
      const bool from_catalogue = !node && find("catalogue");
      if (from_catalogue) node = find("catalogue");
      throw InputError(fmt::format("{}: {}{}{}", place(node), key, message.substr(name.size()),
                                   from_catalogue ? " (from the catalogue)" : ""),
                       at(key, node));
    }
    throw InputError(fmt::format("{}: [{}] {}", place(), name_, message), at());
  }

 private:
  std::string source_, name_;
  const toml::table* table_;
};

}  // namespace raceway::io
