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
/// for each temperature that varies by more than 0.5 K. If more than four temperatures vary, the
/// file has no channel, and a comment gives the command that identifies a model with all
/// temperatures (raceway identify --lags auto). If no temperature varies, the file has one channel
/// for the speed. If the speed does not vary either, the file has no channel.
///
/// Assumed values are marked as assumed. The tolerance is a tenth of the range of the displacement,
/// but at least 0.1 um. The time constants are a tenth of the duration of the longest run. The
/// assumed gains give every channel the same share of the range of the displacement. If raceway
/// does not know the column names of the record, the file also has the table [columns] of
/// suggested_columns(). This table also contains the entries of `options.columns`. A doubtful unit
/// of a column causes only a note, not an error, because the new file contains no results.
///
/// Throws InputError if read_series() rejects the record, or if no column is a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
