#pragma once

#include <string>
#include <vector>

#include "files/source.h"

namespace raceway::session {

using files::Source;

/// Returns the files at these paths as sources.
[[nodiscard]] inline std::vector<Source> files(const std::vector<std::string>& paths) {
  return {paths.begin(), paths.end()};
}

}  // namespace raceway::session
