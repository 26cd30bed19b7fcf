#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/parameter.h"
#include "record/units.h"

/// Types for the tables of keys in model files. Each reader of a model file defines its own tables.
/// files/key_tables.h collects all tables.
namespace raceway::files {

/// Kind and allowed values of a key in a model file.
struct Form {
  std::string_view kind;                ///< "number", "text", "true or false", "list" or "table"
  double lower = unset, upper = unset;  ///< smallest and largest allowed number, in `unit`
  std::string_view unit{};              ///< unit of a number; "" if dimensionless
  std::string_view words{};  ///< allowed texts, such as "rigid|spring"; "" if any text is allowed
  bool whole = false;        ///< true: the number must be whole

  /// Returns the allowed texts as a list; empty if any text is allowed.
  [[nodiscard]] std::vector<std::string> choices() const {
    std::vector<std::string> list;
    for (std::size_t begin = 0, end = 0; end < words.size(); begin = end + 1) {
      end = std::min(words.find('|', begin), words.size());
      list.emplace_back(words.substr(begin, end - begin));
    }
    return list;
  }
};

struct Required {};

/// Default for a key that a model file does not contain.
struct Default {
  /// Default number, in the unit of the key. If `value` is NaN and `words` is empty, the key has no
  /// default.
  double value = unset;
  std::string_view words{};  ///< one of the allowed texts, or a description of the default
  bool required = false;     ///< true: no default; the table must contain the key

  constexpr Default() = default;
  template <std::floating_point Number>
  constexpr Default(Number number) : value(number) {}
  constexpr Default(std::string_view text) : words(text) {}
  constexpr Default(const char* text) : words(text) {}
  Default(const std::string& text) : words(text) {}
  constexpr Default(Required) : required(true) {}
};

struct Key {
  /// Name with unit. A part in capitals, such as NAME, is a placeholder for a name that the user
  /// chooses.
  std::string_view name;
  Form form;
  Default fallback;
  std::string_view meaning;

  /// Returns a copy of this key with another name and unit.
  [[nodiscard]] constexpr Key as(std::string_view other, std::string_view unit) const {
    Key key = *this;
    key.name = other;
    key.form.unit = unit;
    return key;
  }
};

/// Keys that one part of the program reads from one table of a model file.
struct KeyTable {
  /// Name such as "bearing" or "correction.channel". A part in capitals is a placeholder for a name
  /// that the user chooses.
  std::string_view name;
  std::span<const Key> keys;
  /// Kind of model that can contain the table, such as "of a spindle" or "law skf"; "" if every
  /// model can contain the table.
  std::string_view only{};
};

// Helpers for writing tables of keys.
constexpr Form between(double lower, double upper, std::string_view unit = {}) {
  return {.kind = "number", .lower = lower, .upper = upper, .unit = unit};
}
constexpr Form between(const record::NumberCard& card) {
  return between(card.lower, card.upper, card.unit == "1" ? "" : card.unit);
}
constexpr Form whole(double lower, double upper) {
  return {.kind = "number", .lower = lower, .upper = upper, .whole = true};
}
constexpr Form one_of(std::string_view words) { return {.kind = "text", .words = words}; }
inline constexpr Form a_text{.kind = "text"}, a_flag{.kind = "true or false"},
    a_list{.kind = "list"}, a_table{.kind = "table"};
inline constexpr Required is_required;

}  // namespace raceway::files
