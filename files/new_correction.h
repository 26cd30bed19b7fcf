#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"

namespace raceway::files {

struct NewCorrection {
  std::string text;                   ///< contents of a model file
  std::vector<record::Note> notes{};  ///< on its record, and on assumptions
};

/// Makes a first model file for the displacements of a record over time: one channel for each
/// temperature that varies by more than 0.5 K, or one of the speed if there is none. More than four
/// temperatures get a bank of lags instead of channels. Their gains, their time constants and the
/// tolerance are marked as assumed: a tenth of the record, of its displacement, and shares of the
/// latter. Headers of other programs become its [columns], as suggested_columns() proposes them;
/// the columns of `options` stay as they are. Units that look wrong are notes: the file has no
/// result.
///
/// Throws InputError as read_series(), and for a record without a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
