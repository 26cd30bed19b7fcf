#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/model_section.h"
#include "io/named_files.h"

namespace raceway::io {

/// The tables of a model file, and the defaults that were used in reading them. Shared by its
/// readers, not for other code.
class ModelTables {
 public:
  ModelTables(std::string_view text, const std::string& source, std::vector<NamedFile> held = {})
      : ModelTables(parse_toml(text, source), source, std::move(held)) {}
  ModelTables(toml::table root, std::string source, std::vector<NamedFile> held = {})
      : root_(std::move(root)), source_(std::move(source)), files_(source_, std::move(held)) {}

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const Names& defaults() const { return defaults_; }
  /// That the model names.
  [[nodiscard]] NamedFiles& files() { return files_; }
  [[nodiscard]] std::string place(const toml::key& key) const {
    return fmt::format("{}:{}", source_, key.source().begin.line);
  }
  [[nodiscard]] Place at(const toml::key& key) const {
    return {.file = source_,
            .line = static_cast<int>(key.source().begin.line),
            .key = std::string(key.str())};
  }

  [[nodiscard]] Section section(std::string_view name) const {
    return Section(source_, std::string(name), root_[name].as_table());
  }
  [[nodiscard]] Section required_section(std::string_view name, std::string_view holds) const {
    Section result = section(name);
    if (!result.given())
      throw MissingKey(fmt::format("{}: table [{}] is missing; it holds {}", source_, name, holds),
                       {.file = source_, .key = std::string(name)});
    return result;
  }

  void note_default(std::string_view table, std::string_view key, const std::string& value,
                    std::string_view why = "default") {
    if (KeyBook* const book = KeyBook::open())
      book->entry(table, key).fallback = why == "default" ? value : std::string(why);
    defaults_.push_back(fmt::format("{}.{} = {} ({})", table, key, value, why));
  }
  double number_or(const Section& s, const Key& key, double fallback) {
    if (const auto value = s.number(key)) return *value;
    note_default(s.name(), key.name, fmt::format("{:.10g}", fallback));
    return fallback;
  }
  std::string choice_or(const Section& s, std::string_view key, const Names& allowed,
                        const std::string& fallback) {
    if (auto value = s.choice(key, allowed)) return *value;
    note_default(s.name(), key, fmt::format("\"{}\"", fallback));
    return fallback;
  }

 private:
  toml::table root_;
  std::string source_;
  Names defaults_;
  NamedFiles files_;
};

}  // namespace raceway::io
