#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"

namespace raceway::files {

struct NewCorrection {
  std::string text;                   ///< contents of a model file
  std::vector<record::Note> notes{};  ///< notes on the record and on assumptions
};

/// Makes a first model file for the displacements of a record over time. The file has one channel
/// for each temperature that varies by more than 0.5 K. If there is no such temperature, the file
/// has one channel for the speed, if the speed varies. If there are more than four such
/// temperatures, the file has no channel. A comment in the file then gives the command for a bank
/// of lags.
///
/// Assumed values are marked: the tolerance is a tenth of the range of the displacement, a time
/// constant is a tenth of the record, and the gains divide the range equally among the channels.
/// Headers of other programs become [columns], as in suggested_columns(). Rules in
/// `options.columns` are kept. A doubtful unit gives only a note and no error, because this file
/// contains no results.
///
/// Throws InputError like read_series(), and for a record without a displacement.
[[nodiscard]] NewCorrection new_correction(const Source& record, const ReadOptions& options);

}  // namespace raceway::files
