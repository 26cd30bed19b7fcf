#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "io/column_map.h"

namespace raceway::io {

/// Correction models as read from their file: one for each displacement.
struct CorrectionFile {
  std::vector<correction::Model> models;
  std::string source;                   ///< file name, for messages
  std::string text;                     ///< of the file, to be edited
  std::vector<std::string> defaults{};  ///< every default that was used
  std::vector<std::string> notes{};     ///< what else the user should know
  ColumnMap columns{};                  ///< how its measurements are written
};

/// Whether a model file has a table [correction], or a list of them. False for what cannot be read:
/// the reader then says why.
[[nodiscard]] bool has_correction(const std::string& path);

/// Reads [correction] (keys with their units: docs/files.md) into SI. Files that it names are
/// looked for beside it.
///
/// Throws InputError naming file, line, key, value and allowed range.
[[nodiscard]] CorrectionFile read_correction(const std::string& path);

/// The same from text; `source` stands in messages, and names of files are relative to it.
[[nodiscard]] CorrectionFile parse_correction(std::string text, const std::string& source);

/// The text with the numbers, sections, channels, effects and ranges of these models, which are
/// those of the file or grew out of them; comments and all else are kept.
[[nodiscard]] std::string with_corrections(const CorrectionFile& file,
                                           const std::vector<correction::Model>& models);

}  // namespace raceway::io
