#pragma once

#include <string>

namespace raceway::tests {

/// Top folder of the sources, as an absolute path.
[[nodiscard]] std::string source_dir();

/// The built command `raceway`; empty where it is not built.
[[nodiscard]] std::string program();

}  // namespace raceway::tests
