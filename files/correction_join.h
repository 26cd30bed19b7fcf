#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/correction_file.h"

namespace raceway::files {

/// A correction file made from several correction files.
struct JoinedCorrection {
  std::string text;
  std::vector<NamedFile> files{};     ///< files named in the text, if no path leads to them
  std::vector<record::Note> notes{};  ///< notes on omitted parts
};

/// Sums corrections of one displacement. The joined file has all their channels, laws and effects
/// unchanged. Offsets are added. A range that several files give becomes the intersection of these
/// ranges. Parameters that a file fits stay free, and so do parameters with a prior. Parameters
/// fitted to a record get a prior from their covariance. Delay elements and laws from step
/// responses that were never fitted get the priors of correction/prior.h. The priors are needed
/// because a record of the whole machine seldom separates the parts. Names of files are relative to
/// `path`.
///
/// Throws InputError for fewer than two files, for a file with several displacements or with
/// another displacement, for two channels with the same name, for two laws of kinematic
/// displacement, and for ranges without a common part.
[[nodiscard]] JoinedCorrection join_corrections(std::span<const CorrectionFile> files,
                                                const std::string& path);

}  // namespace raceway::files
