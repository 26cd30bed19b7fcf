#pragma once

#include <string>
#include <vector>

namespace raceway::files {

/// What a model file describes, by its tables. Nothing of text that is no TOML: the reader then
/// says why.
struct ModelParts {
  bool bearing = false;                      ///< has [bearing]
  std::vector<std::string> displacements{};  ///< of [correction], or of each [[correction]]
};
[[nodiscard]] ModelParts parts_of(const std::string& text);
/// Of a file, or of standard input for `-`, which is still there to be read. Nothing of one that
/// cannot be read.
[[nodiscard]] ModelParts parts_of_file(const std::string& path);

}  // namespace raceway::files
