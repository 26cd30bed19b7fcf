#pragma once

#include <string>
#include <vector>

namespace raceway::files {

/// Tables that a model file contains. `bearing` is false and `displacements` is empty if the text
/// is not TOML; parse_model() reports this error.
struct ModelParts {
  bool bearing = false;  ///< true: the file has a table [bearing]
  /// Column names of the displacements in [correction] or [[correction]].
  std::vector<std::string> displacements{};
};
[[nodiscard]] ModelParts parts_of(const std::string& text);
/// Returns the tables of a file, or of standard input for `-`. Standard input can still be read
/// afterwards. For a file that cannot be read, the result has no tables.
[[nodiscard]] ModelParts parts_of_file(const std::string& path);

}  // namespace raceway::files
