#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"

namespace raceway::files {

struct NewCorrection {
  std::string text;                   ///< contents of a model file
  std::vector<record::Note> notes{};  ///< notes on its record and on assumptions
};

/// Makes a first model file for the displacements of a record over time. The file has one channel
/// for each temperature that varies by more than 0.5 K. Without such a temperature it has one
/// channel for the speed. With more than four temperatures it has no channel, but a comment with
/// the command for a bank of lags.
///
/// Assumed values are marked: the tolerance is a tenth of the range of the displacement, a time
/// constant is a tenth of the record, and each channel gets an equal share of the range as its
/// gain. Headers of other programs become [columns], as in suggested_columns(). The columns of
/// `options` do not change. Units that look wrong give notes only, because the file has no result.
///
/// Throws InputError as read_series(), and for a record without a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
