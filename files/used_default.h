#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

namespace raceway::files {

/// A value that a model assumes: the default of a missing key, or a value marked as a guess.
struct UsedDefault {
  enum class Origin {
    marked,     ///< value in the file, marked by the comment `why`
    key,        ///< default of the key
    catalogue,  ///< value of the bearing that the file names
    derived,    ///< value calculated from other values, as stated in `why`
  };
  std::string table, key;  ///< `effect[0]` is the first effect
  std::string value;       ///< value as in a file, or in words
  Origin origin = Origin::key;
  std::string why = {};  ///< reason for the reader; empty for Origin::key

  /// Returns `solver.tilt = "locked"`, with the reason if there is one.
  [[nodiscard]] std::string short_line() const {
    return fmt::format("{}.{} = {}{}", table, key, value,
                       why.empty() ? "" : fmt::format(" ({})", why));
  }
  /// Returns `solver.tilt = "locked" (default)`; if there is a reason, it replaces "default".
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
