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
  std::string source;                   ///< file name, for messages
  std::string text;                     ///< text of the file, for editing
  std::vector<UsedDefault> defaults{};  ///< default values used, and values marked as assumed
  std::vector<record::Note> notes{};    ///< other notes for the user
  ColumnMap columns{};                  ///< assignment of file columns to channels, from [columns]
  correction::ControlSettings control{};  ///< settings for the machine control from [export]
  std::vector<NamedFile> files{};         ///< files that the correction names, with their contents
};

/// Reads a correction file and converts it to SI. `raceway keys` lists the keys with their units.
/// File names in the correction file are relative to the folder of this file.
///
/// Throws InputError with file, line, key, value and allowed range for invalid contents.
[[nodiscard]] CorrectionFile read_correction(const std::string& path);

/// Parses the text of a correction file; `source` is the file name in messages. File names in the
/// text are relative to the folder of `source`. `held` contains files whose contents are already
/// known; these files are not read again.
[[nodiscard]] CorrectionFile parse_correction(std::string text, const std::string& source,
                                              std::vector<NamedFile> held = {});

/// Returns the text of the table [correction.prior] for a model; empty if the model has no priors.
/// A prior is the expected value of a parameter with a standard deviation.
[[nodiscard]] std::string prior_text(const correction::Model& model);

/// Returns the line of a correction file that limits a channel or an effect to a range of an axis
/// position or a speed (correction::Window).
[[nodiscard]] std::string window_text(const correction::Window& window);

/// Returns the text of a new correction file for these models. The text contains the offset, the
/// tolerance and the input ranges of each model, and the channels whose inputs are columns of the
/// record. `comment` is the first line of the file.
[[nodiscard]] std::string new_corrections(const std::vector<correction::Model>& models,
                                          const std::string& comment);

/// Returns the text of `file`, in which the parameters, lags, channels, effects and input ranges of
/// `models` replace the original ones. `models` must be changed copies of the models in `file`. All
/// other text, such as comments, stays unchanged.
[[nodiscard]] std::string with_corrections(const CorrectionFile& file,
                                           const std::vector<correction::Model>& models);

}  // namespace raceway::files
