#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/detail/model_section.h"
#include "files/named_files.h"
#include "files/used_default.h"

namespace raceway::files {

/// All tables of a model file, and the defaults that were used for missing keys.
class ModelTables {
 public:
  ModelTables(std::string_view text, const std::string& source, std::vector<NamedFile> held = {})
      : ModelTables(text::parse_toml(text, source), source, std::move(held)) {}
  ModelTables(toml::table root, std::string source, std::vector<NamedFile> held = {})
      : root_(std::move(root)), source_(std::move(source)), files_(source_, std::move(held)) {}

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<UsedDefault>& defaults() const { return defaults_; }
  /// Returns the reader of the files that the model names.
  [[nodiscard]] NamedFiles& files() { return files_; }
  [[nodiscard]] std::string place(const toml::key& key) const {
    return fmt::format("{}:{}", source_, key.source().begin.line);
  }
  [[nodiscard]] text::Place at(const toml::key& key) const {
    return {.file = source_,
            .line = static_cast<int>(key.source().begin.line),
            .key = std::string(key.str())};
  }

  /// Returns the table `name` with all keys that it may have: see Section.
  [[nodiscard]] Section section(std::string_view name, Keys keys = {}) const {
    return {source_, std::string(name), root_[name].as_table(), std::move(keys)};
  }
  [[nodiscard]] Section required_section(std::string_view name, std::string_view holds,
                                         Keys keys = {}) const {
    Section result = section(name, std::move(keys));
    if (!result.given())
      throw MissingKey(
          fmt::format("{}: table [{}] is missing; it contains {}", source_, name, holds),
          {.file = source_, .key = std::string(name)});
    return result;
  }
  /// Returns the table `name` with some of its keys: see Section::part().
  [[nodiscard]] Section part(std::string_view name, Keys keys) const {
    return section(name).part(std::move(keys));
  }

  void note_default(std::string_view table, std::string_view key, std::string value,
                    std::string why = {},
                    UsedDefault::Origin origin = UsedDefault::Origin::derived) {
    if (why.empty()) origin = UsedDefault::Origin::key;
    defaults_.push_back(
        {std::string(table), std::string(key), std::move(value), origin, std::move(why)});
  }
  /// Records the use of a default that the key describes in words.
  void note_default(const Section& s, std::string_view key, const std::string& value) {
    note_default(s.name(), key, value, fmt::format("default: {}", s.key(key).fallback.words));
  }
  /// Returns the number of a key. If the key is missing, returns the default and records its use.
  double number(const Section& s, std::string_view key, double fallback) {
    if (const auto value = s.number(key)) return *value;
    note_default(s.name(), key, fmt::format("{:.10g}", fallback));
    return fallback;
  }
  double number(const Section& s, std::string_view key) {
    return number(s, key, s.key(key).fallback.value);
  }
  std::string choice(const Section& s, std::string_view key, const Names& allowed) {
    if (auto value = s.choice(key, allowed)) return *value;
    std::string fallback(s.key(key).fallback.words);
    note_default(s.name(), key, fmt::format("\"{}\"", fallback));
    return fallback;
  }
  std::string choice(const Section& s, std::string_view key) {
    return choice(s, key, s.key(key).form.choices());
  }

 private:
  toml::table root_;
  std::string source_;
  std::vector<UsedDefault> defaults_;
  NamedFiles files_;
};

}  // namespace raceway::files
