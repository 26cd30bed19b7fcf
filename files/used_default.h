#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

namespace raceway::files {

/// An assumed value of a model: the default of a missing key, or a value that the file marks as
/// assumed or estimated.
struct UsedDefault {
  enum class Origin {
    marked,     ///< value in the file, marked as assumed or estimated by the comment `why`
    key,        ///< default of the key
    catalogue,  ///< value of the catalogue bearing that the file names
    derived,    ///< value that is calculated from other values, as `why` states
  };
  /// Table and key in the model file; the table of the first effect is `effect[0]`.
  std::string table, key;
  std::string value;  ///< value as written in a model file, or a description
  Origin origin = Origin::key;
  std::string why = {};  ///< reason for the value; empty for Origin::key

  /// Returns a line such as `solver.tilt = "locked"`, with the reason in parentheses if there is
  /// one.
  [[nodiscard]] std::string short_line() const {
    return fmt::format("{}.{} = {}{}", table, key, value,
                       why.empty() ? "" : fmt::format(" ({})", why));
  }
  /// Returns a line such as `solver.tilt = "locked" (default)`. If `why` is not empty, the
  /// parentheses contain `why` instead of the word "default".
  [[nodiscard]] std::string line() const {
    return short_line() + (why.empty() ? " (default)" : "");
  }
};

[[nodiscard]] inline std::vector<std::string> lines(std::span<const UsedDefault> defaults) {
  std::vector<std::string> list;
  for (const UsedDefault& one : defaults) list.push_back(one.line());
  return list;
}

[[nodiscard]] inline std::vector<std::string> short_lines(std::span<const UsedDefault> defaults) {
  std::vector<std::string> list;
  for (const UsedDefault& one : defaults) list.push_back(one.short_line());
  return list;
}

}  // namespace raceway::files
