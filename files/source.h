#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/named_files.h"
#include "text/csv.h"

namespace raceway::files {

/// Source of data: a file, a text, or columns of measurements.
struct Source {
  std::string name;  ///< path of the file, or a name for messages
  /// Content of the file; null if it has not been read.
  std::shared_ptr<const std::string> text;
  /// Columns of measurements; null if they are read from the text or the file.
  std::shared_ptr<const text::CsvTable> table;
  /// Files that a model names, with the contents that they had when the model was read. Files that
  /// are not in this list are read from disk.
  std::vector<NamedFile> files{};
  /// Other files of the same time record, each with its own rows and times.
  std::vector<Source> beside{};

  Source(std::string path) : name(std::move(path)) {}  // NOLINT: a path is a source
  Source(const char* path) : name(path) {}             // NOLINT
  Source(std::string name_of_text, std::string content, std::vector<NamedFile> named = {})
      : name(std::move(name_of_text)),
        text(std::make_shared<const std::string>(std::move(content))),
        files(std::move(named)) {}
  explicit Source(std::shared_ptr<const text::CsvTable> columns)
      : name(columns->source), table(std::move(columns)) {}
};

/// Returns a source that can be read several times. Standard input and pipes are read, and the
/// result contains their text.
[[nodiscard]] Source repeatable(const Source& source);

}  // namespace raceway::files
