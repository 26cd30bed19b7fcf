#pragma once

#include <string>
#include <vector>

#include "files/source.h"

namespace raceway::session {

using files::Source;

/// Returns files by their paths.
[[nodiscard]] inline std::vector<Source> files(const std::vector<std::string>& paths) {
  return {paths.begin(), paths.end()};
}

}  // namespace raceway::session
