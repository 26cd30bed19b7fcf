#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/correction_file.h"

namespace raceway::files {

/// Text of a joined correction file, with notes for the user.
struct JoinedCorrection {
  std::string text;
  /// Files that the text names; only filled if `path` of join_corrections() is empty.
  std::vector<NamedFile> files{};
  /// Notes on unused tables, and a note that the trust in the sum is unknown.
  std::vector<record::Note> notes{};
};

/// Returns a correction file whose prediction is the sum of the corrections of several files for
/// one displacement. The joined file contains the channels, kinematic law and effects of all files,
/// unchanged. Offsets are added. If several files give a range for the same input, the new range is
/// the intersection of these ranges.
///
/// Each parameter of the joined file that has a prior is free. Parameters fitted to a record,
/// except the offset, get a prior from their covariance. The other parameters keep the prior of
/// their file. If a file has neither priors nor a list of free parameters, its kinematic law and
/// its channels with a delay element (a lag whose gain and time constant depend on the input) get
/// the priors of correction/prior.h. The priors are needed because a record of the whole machine
/// seldom separates the displacements of the single files.
///
/// Parameters that are free in their own file stay free, with one exception: in a file without a
/// list of free parameters, the kinematic law is free only with a prior. File names in the text are
/// relative to the folder of `path`, or absolute if `path` is empty.
///
/// Throws InputError for fewer than two files, for a file with several displacements or with
/// another displacement, for two channels with the same name, for two kinematic laws, for different
/// sampling intervals, for a channel, law or effect in an inline table, and for input ranges that
/// do not overlap.
[[nodiscard]] JoinedCorrection join_corrections(std::span<const CorrectionFile> files,
                                                const std::string& path);

}  // namespace raceway::files
