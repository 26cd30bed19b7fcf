#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "files/key.h"
#include "text/detail/toml_text.h"
#include "text/error.h"
#include "text/names.h"

/// Reads single tables of a model file and checks their keys.
namespace raceway::files {

using Names = std::vector<std::string>;

inline std::string with_unit(std::string_view number, std::string_view unit) {
  return unit.empty() || unit == "1" ? std::string(number) : fmt::format("{} {}", number, unit);
}

inline std::string range(const Key& key) {
  return fmt::format("must be from {} to {}", key.form.lower,
                     with_unit(fmt::format("{}", key.form.upper), key.form.unit));
}

/// Returns the names of enumerators, separated by "|", as in Form::words.
template <typename Enumerators>
std::string names_as_words(const Enumerators& all) {
  std::string words;
  for (const auto one : all) words += (words.empty() ? "" : "|") + std::string(name(one));
  return words;
}

/// Keys of a table, in several lists if several functions read the table.
using Keys = std::vector<std::span<const Key>>;

inline std::string_view kind(const toml::node& node) {
  if (node.is_string()) return "a text";
  if (node.is_number()) return "a number";
  if (node.is_boolean()) return "true or false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

/// Exception: the file lacks a required key.
struct MissingKey : text::InputError {
  using text::InputError::InputError;
};

/// One table of a model file and its possible keys. The functions that read a value check its type
/// and range. These functions throw std::logic_error for a key that is not in `keys`.
class Section {
 public:
  /// If `table` is null, all keys are missing. If `keys` is not empty, throws InputError for other
  /// keys in the table.
  Section(std::string source, std::string name, const toml::table* table, Keys keys = {})
      : source_(std::move(source)), name_(std::move(name)), table_(table), keys_(std::move(keys)) {
    if (!keys_.empty()) refuse_others();
  }
  /// Returns this table with `keys` as its possible keys. Throws InputError if the table has other
  /// keys.
  [[nodiscard]] Section with(Keys keys) const { return {source_, name_, table_, std::move(keys)}; }
  /// Returns this table with some of its keys. The table may have other keys.
  [[nodiscard]] Section part(Keys keys) const {
    Section result = *this;
    result.keys_ = std::move(keys);
    return result;
  }

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
  /// Returns the file and the line of `node`, a part of the value of `key`. If `node` is null,
  /// returns the line of the key. If the key is missing too, returns the line of this table.
  [[nodiscard]] text::Place at(std::string_view key = {}, const toml::node* node = nullptr) const {
    if (!node && !key.empty()) node = find(key);
    if (!node) node = table_;
    return {.file = source_,
            .line = node ? static_cast<int>(node->source().begin.line) : 0,
            .key = std::string(key.empty() ? name_ : key)};
  }
  [[noreturn]] void fail(std::string_view key, const std::string& text) const {
    throw text::InputError(fmt::format("{}: {}", place(find(key)), text), at(key));
  }
  [[noreturn]] void fail_missing(const Key& key, const std::string& why = "") const {
    const std::string wanted = !key.form.words.empty()
                                   ? ": must be " + text::listed(key.form.choices(), "or")
                               : key.form.kind == "number" ? ": " + range(key)
                                                           : "";
    throw MissingKey(
        fmt::format("{}: [{}] {} is missing{}{}", place(), name_, key.name, why, wanted),
        at(key.name));
  }
  [[noreturn]] void fail_missing(std::string_view name, const std::string& why = "") const {
    fail_missing(key(name), why);
  }
  /// Returns those of the keys `names` that the table lacks, each as a text such as "[bearing]
  /// ball_count: must be from 3 to 200".
  [[nodiscard]] Names lacking(std::initializer_list<std::string_view> names) const {
    Names list;
    for (const std::string_view one : names)
      if (!find(one)) list.push_back(fmt::format("[{}] {}: {}", name_, one, range(key(one))));
    return list;
  }

  [[nodiscard]] const Key& key(std::string_view name) const {
    for (const std::span<const Key> part : keys_)
      for (const Key& one : part)
        if (one.name == name) return one;
    throw std::logic_error(fmt::format("[{}] has no key {}", name_, name));
  }

  /// Returns the number of a key; nothing if an optional key is missing. Throws InputError if a
  /// required key is missing, or if the value is not a number in the allowed range.
  [[nodiscard]] std::optional<double> number(std::string_view name) const {
    return number(key(name));
  }
  /// Returns the number of a key that need not be in `keys`.
  [[nodiscard]] std::optional<double> number(const Key& key) const {
    const toml::node* const node = find(key.name);
    if (!node && table_ && key.fallback.required) fail_missing(key);
    if (!node) return std::nullopt;
    if (!node->is_number())
      fail(key.name, fmt::format("{} = {}: must be a number, not {}; {}", key.name,
                                 text::shown(*node), kind(*node), range(key)));
    const double value = *node->value<double>();
    if (!(value >= key.form.lower && value <= key.form.upper))
      fail(key.name, fmt::format("{} = {}: {}", key.name,
                                 with_unit(text::shown(*node), key.form.unit), range(key)));
    return value;
  }
  /// Writes the number times `unit` to `to` and returns true if the table has the key. Otherwise
  /// `to` does not change.
  bool take(std::string_view name, double& to, double unit = 1.0) const {
    const std::optional<double> given = number(name);
    if (given) to = *given * unit;
    return given.has_value();
  }
  /// Returns the number of a key; the default if the key is missing.
  [[nodiscard]] double value(std::string_view name) const {
    return number(name).value_or(key(name).fallback.value);
  }
  [[nodiscard]] double required(std::string_view name) const {
    if (const auto value = number(name)) return *value;
    fail_missing(name);
  }
  [[nodiscard]] std::optional<int> whole_number(std::string_view name) const {
    const auto value = number(name);
    if (!value) return std::nullopt;
    if (*value != std::floor(*value))
      fail(name, fmt::format("{} = {}: must be a whole number from {} to {}", name, *value,
                             key(name).form.lower, key(name).form.upper));
    return static_cast<int>(*value);
  }
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const {
    return text_of(key(name).name);
  }
  /// Returns the text of a key; empty if the key is missing or its value is not a text.
  [[nodiscard]] std::string text_or_empty(std::string_view key) const {
    const toml::node* const node = find(key);
    return node && node->is_string() ? *node->value<std::string>() : std::string();
  }
  /// Returns the text of a key; nothing if the key is missing. Throws InputError if the text is not
  /// one of the allowed texts.
  [[nodiscard]] std::optional<std::string> choice(std::string_view name) const {
    return choice(name, key(name).form.choices());
  }
  [[nodiscard]] std::optional<std::string> choice(std::string_view key,
                                                  const Names& allowed) const {
    auto value = text_of(key);
    if (value && std::find(allowed.begin(), allowed.end(), *value) == allowed.end())
      fail(key, fmt::format("{} = \"{}\": must be {}{}", key, *value, text::listed(allowed, "or"),
                            text::suggestion(*value, allowed)));
    return value;
  }

  /// Throws InputError with the message of a library exception, such as `ball_diameter = -12 mm:
  /// ...`. The key of the file replaces the name, and file and line are added.
  [[noreturn]] void fail(const std::invalid_argument& error) const {
    std::string message = error.what();
    const std::string owner =
        name_.starts_with("material.") ? "material " + name_.substr(9) + ": " : "";
    if (!owner.empty() && message.starts_with(owner)) message.erase(0, owner.size());
    const std::string name = message.substr(0, message.find(' '));
    for (const std::string& key : names()) {
      if (key != name && !key.starts_with(name + "_")) continue;
      const toml::node* node = find(key);
      const bool from_catalogue = !node && find("catalogue");
      if (from_catalogue) node = find("catalogue");
      throw text::InputError(
          fmt::format("{}: {}{}{}", place(node), key, message.substr(name.size()),
                      from_catalogue ? " (from the catalogue)" : ""),
          at(key, node));
    }
    throw text::InputError(fmt::format("{}: [{}] {}", place(), name_, message), at());
  }

 private:
  [[nodiscard]] Names names() const {
    Names all;
    for (const std::span<const Key> part : keys_)
      for (const Key& one : part) all.emplace_back(one.name);
    return all;
  }
  void refuse_others() const {
    if (!table_) return;
    const Names known = names();
    for (const auto& [key, node] : *table_) {
      const std::string_view given = key.str();
      if (std::find(known.begin(), known.end(), given) != known.end()) continue;
      const std::string near = text::suggestion(given, known);
      throw text::InputError(fmt::format("{}:{}: {} = {}: unknown key in [{}]{}", source_,
                                         key.source().begin.line, given, text::shown(node), name_,
                                         near.empty() ? "; it has " + text::listed(known) : near),
                             {.file = source_,
                              .line = static_cast<int>(key.source().begin.line),
                              .key = std::string(given)});
    }
  }
  [[nodiscard]] std::optional<std::string> text_of(std::string_view key) const {
    const toml::node* const node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string())
      fail(key, fmt::format("{} = {}: must be a text in quotes, not {}", key, text::shown(*node),
                            kind(*node)));
    return *node->value<std::string>();
  }

  std::string source_, name_;
  const toml::table* table_;
  Keys keys_;
};

}  // namespace raceway::files
