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
  ColumnMap columns{};                    ///< rules for the columns of measurements
  correction::ControlSettings control{};  ///< settings of the control from [export]
  std::vector<NamedFile> files{};         ///< files that the correction names, as they were read
};

/// Reads [correction] into SI. `raceway keys` lists the keys with their units. File names in the
/// correction are relative to the folder of the file.
///
/// Throws InputError with file, line, key, value and allowed range.
[[nodiscard]] CorrectionFile read_correction(const std::string& path);

/// Parses [correction] from text; `source` is the file name in messages. File names are relative to
/// the folder of `source`. Files in `held` are not read again.
[[nodiscard]] CorrectionFile parse_correction(std::string text, const std::string& source,
                                              std::vector<NamedFile> held = {});

/// Returns the table [correction.prior] of a model; empty without priors.
[[nodiscard]] std::string prior_text(const correction::Model& model);

/// Returns the line of a file that defines a window of a channel or an effect.
[[nodiscard]] std::string window_text(const correction::Window& window);

/// Returns the text of a new file with only these models: their channels with columns, offsets,
/// tolerances and ranges. `comment` is the first line of the file.
[[nodiscard]] std::string new_corrections(const std::vector<correction::Model>& models,
                                          const std::string& comment);

/// Returns the text of `file` with the numbers, sections, channels, effects and ranges of these
/// models. `models` are the models of `file` with changes or additions. Comments and everything
/// else stay unchanged.
[[nodiscard]] std::string with_corrections(const CorrectionFile& file,
                                           const std::vector<correction::Model>& models);

}  // namespace raceway::files
