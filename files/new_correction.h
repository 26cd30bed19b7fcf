#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"

namespace raceway::files {

struct NewCorrection {
  std::string text;                   ///< of a model file
  std::vector<record::Note> notes{};  ///< of its record, and of what was assumed
};

/// A model file to begin with for the displacements of a record over time: one channel for each
/// temperature that varies by more than 0.5 K, of the speed where there is none, and no channel for
/// more than four, which a bank of lags takes. Their gains, their time constants and the tolerance
/// are marked as assumed: a tenth of the record, of its displacement, and shares of the latter.
/// Headers that are not ours become its [columns], as suggested_columns() proposes them; the
/// columns of `options` stay as they are. Units that look wrong are notes: the file has no result.
///
/// Throws InputError as read_series(), and for a record without a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
