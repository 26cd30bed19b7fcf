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

/// Contents of a correction file: one model for each displacement.
struct CorrectionFile {
  std::vector<correction::Model> models;
  std::string source;                     ///< file name, for messages
  std::string text;                       ///< text of the file, for editing
  std::vector<UsedDefault> defaults{};    ///< defaults used, and values marked as assumed
  std::vector<record::Note> notes{};      ///< other notes for the user
  ColumnMap columns{};                    ///< rules for the columns of measurements
  correction::ControlSettings control{};  ///< settings for the machine control from [export]
  std::vector<NamedFile> files{};         ///< files that the correction names, with their contents
};

/// Reads a correction file and converts it to SI. `raceway keys` lists the keys with their units.
/// File names in the correction file are relative to the folder of this file.
///
/// Throws InputError with file, line, key, value and allowed range for invalid contents.
[[nodiscard]] CorrectionFile read_correction(const std::string& path);

/// Parses the text of a correction file; `source` is the file name in messages. File names in the
/// text are relative to the folder of `source`. The contents of files in `held` are not read again.
[[nodiscard]] CorrectionFile parse_correction(std::string text, const std::string& source,
                                              std::vector<NamedFile> held = {});

/// Returns the text of the table [correction.prior] for a model; empty without priors.
[[nodiscard]] std::string prior_text(const correction::Model& model);

/// Returns the line of a correction file that limits a channel or an effect to a range of axis
/// positions (correction::Window).
[[nodiscard]] std::string window_text(const correction::Window& window);

/// Returns the text of a new correction file with these models: their offsets, tolerances, input
/// ranges, and the channels whose inputs are columns of the record. `comment` is the first line of
/// the file.
[[nodiscard]] std::string new_corrections(const std::vector<correction::Model>& models,
                                          const std::string& comment);

/// Returns the text of `file` with the parameters, lags, channels, effects and input ranges of
/// `models`, which are changed models of `file`. Comments and everything else stay unchanged.
[[nodiscard]] std::string with_corrections(const CorrectionFile& file,
                                           const std::vector<correction::Model>& models);

}  // namespace raceway::files
