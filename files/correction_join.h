#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/correction_file.h"

namespace raceway::files {

/// Text of a joined correction file, with notes for the user.
struct JoinedCorrection {
  std::string text;
  /// Files whose names occur in the text. The list is empty if the argument `path` of
  /// join_corrections() is not empty.
  std::vector<NamedFile> files{};
  /// Notes on unused tables, and a note that the joined correction must be compared with a record
  /// of the whole machine.
  std::vector<record::Note> notes{};
};

/// Joins several correction files for the same displacement into one file. The prediction of the
/// joined file is the sum of the predictions of the single files. The joined file contains the
/// channels, kinematic law and effects of all files, unchanged. Offsets are added. If several files
/// give a range for the same input, the new range is the intersection of these ranges.
///
/// A record of the whole machine contains only the sum of the displacements that the single files
/// predict, so a fit can seldom separate these displacements. A fit of the joined file therefore
/// needs priors: expected values of parameters with standard deviations. Parameters that were
/// fitted to a record, except the offset, get a prior from their covariance. Other parameters keep
/// the prior of their file. If a file has neither priors nor a list of free parameters, the
/// kinematic law and the delay elements of this file get the priors of computed_priors(). A delay
/// element is a lag whose gain and time constant depend on the input.
///
/// In the joined file, a parameter is free if it has a prior, or if it is free in its original
/// file. Exception: if the original file has no list of free parameters, a parameter of its
/// kinematic law is fixed unless it has a prior. File names in the text are relative to the folder
/// of `path`, or absolute if `path` is empty.
///
/// Throws InputError in these cases:
///   - There are fewer than two files, or a file has several displacements.
///   - The files have different displacements or different sampling intervals.
///   - Two channels have the same name, or two files have a kinematic law.
///   - The ranges of an input in the files do not overlap.
///   - A channel, a kinematic law or an effect is written as an inline table (a table in braces).
[[nodiscard]] JoinedCorrection join_corrections(std::span<const CorrectionFile> files,
                                                const std::string& path);

}  // namespace raceway::files
