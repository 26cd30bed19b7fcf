#pragma once

#include <string>
#include <vector>

namespace raceway::files {

/// Contents of a model file, by its tables. They are empty for text that is no TOML; the reader of
/// the model then gives the reason.
struct ModelParts {
  bool bearing = false;                      ///< has [bearing]
  std::vector<std::string> displacements{};  ///< names in [correction] or in each [[correction]]
};
[[nodiscard]] ModelParts parts_of(const std::string& text);
/// Returns the contents of a file, or of standard input for `-`, which can still be read
/// afterwards. They are empty for a file that cannot be read.
[[nodiscard]] ModelParts parts_of_file(const std::string& path);

}  // namespace raceway::files
