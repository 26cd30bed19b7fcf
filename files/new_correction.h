#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"

namespace raceway::files {

struct NewCorrection {
  std::string text;                   ///< text of the new correction file
  std::vector<record::Note> notes{};  ///< notes on the record and on assumptions
};

/// Makes a first correction file for the displacements of a time record. The file has one channel
/// for each temperature that varies by more than 0.5 K. If there is no such temperature, the file
/// has one channel for the speed, if the speed varies. If there are more than four such
/// temperatures, the file has no channel, and a comment gives the command for a bank of lags.
///
/// Assumed values are marked: the tolerance is a tenth of the range of the displacement, but at
/// least 0.1 um; a time constant is a tenth of the longest run; and the gains divide the range of
/// the displacement equally among the channels. If the column names are not those that raceway
/// reads, the file has a table [columns], as from suggested_columns(). Rules in `options.columns`
/// are kept. A doubtful unit leads only to a note, because the file contains no results.
///
/// Throws InputError like read_series(), and if no column is a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
