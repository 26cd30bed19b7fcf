#pragma once

#include <string>
#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"
#include "files/column_map.h"
#include "files/named_files.h"
#include "files/used_default.h"
#include "record/note.h"

namespace raceway::files {

/// Correction models read from their file, one for each displacement.
struct CorrectionFile {
  std::vector<correction::Model> models;
  std::string source;                     ///< file name, for messages
  std::string text;                       ///< text of the file, for editing
  std::vector<UsedDefault> defaults{};    ///< every default that was used
  std::vector<record::Note> notes{};      ///< further notes for the user
  ColumnMap columns{};                    ///< columns of its measurements
  correction::ControlSettings control{};  ///< settings of its control, [export]
  std::vector<NamedFile> files{};         ///< files that it names, as they were read
};

/// Reads [correction] (keys with their units: raceway keys) into SI. Files that it names are looked
/// for in its folder.
///
/// Throws InputError naming file, line, key, value and allowed range.
[[nodiscard]] CorrectionFile read_correction(const std::string& path);

/// Parses [correction] from text; `source` is the name in messages, and file names are relative to
/// it. Files in `held` are not read again.
[[nodiscard]] CorrectionFile parse_correction(std::string text, const std::string& source,
                                              std::vector<NamedFile> held = {});

/// The table [correction.prior] of a model; empty without priors.
[[nodiscard]] std::string prior_text(const correction::Model& model);

/// Returns the line of a window in a channel or an effect.
[[nodiscard]] std::string window_text(const correction::Window& window);

/// Returns a file of these models alone: channels of columns, offsets, tolerances and ranges.
/// `comment`: its first line.
[[nodiscard]] std::string new_corrections(const std::vector<correction::Model>& models,
                                          const std::string& comment);

/// Returns the text with the numbers, sections, channels, effects and ranges of these models, which
/// come from the file or extend it; comments and all else are kept.
[[nodiscard]] std::string with_corrections(const CorrectionFile& file,
                                           const std::vector<correction::Model>& models);

}  // namespace raceway::files
