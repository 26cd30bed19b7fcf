#pragma once

#include <string>
#include <vector>

namespace raceway::files {

/// Kinds of tables in a model file. All members are empty if the text is not TOML; the reader of
/// the model then reports the error.
struct ModelParts {
  bool bearing = false;                      ///< true: the file has a table [bearing]
  std::vector<std::string> displacements{};  ///< names in [correction] or in each [[correction]]
};
[[nodiscard]] ModelParts parts_of(const std::string& text);
/// Returns the kinds of tables in a file, or in standard input for `-`. Standard input can still be
/// read afterwards. The result is empty for a file that cannot be read.
[[nodiscard]] ModelParts parts_of_file(const std::string& path);

}  // namespace raceway::files
