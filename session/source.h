#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/named_files.h"

namespace raceway::session {

/// A file, or a text that stands for one.
struct Source {
  std::string name;                         ///< path of the file; in messages, of the text too
  std::shared_ptr<const std::string> text;  ///< null: as it stands in the file

  /// Files that the text names, as they were when it was read; others are read where they stand.
  std::vector<io::NamedFile> files{};

  Source(std::string path) : name(std::move(path)) {}  // NOLINT: a path is a source
  Source(std::string name_of_text, std::string content, std::vector<io::NamedFile> named = {})
      : name(std::move(name_of_text)),
        text(std::make_shared<const std::string>(std::move(content))),
        files(std::move(named)) {}
};

/// Files, by their paths.
[[nodiscard]] inline std::vector<Source> files(const std::vector<std::string>& paths) {
  return {paths.begin(), paths.end()};
}

}  // namespace raceway::session
