#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/correction_file.h"

namespace raceway::files {

/// A correction file made from several.
struct JoinedCorrection {
  std::string text;
  std::vector<NamedFile> files{};     ///< files named in it, if there is no path to find them
  std::vector<record::Note> notes{};  ///< notes on omitted parts
};

/// Sums corrections of one displacement: the file has all their channels, laws and effects, as they
/// are written. Offsets are added; a range in several files becomes their intersection. Parameters
/// that a file fits stay free. So do those with a prior; delay elements and laws of step responses
/// that no fit has touched get one (correction/prior.h), and numbers that a record gave have theirs
/// from its covariance: a record of the whole machine seldom tells the parts from each other. Names
/// of files are relative to `path`.
///
/// Throws InputError: fewer than two files, one with several displacements or another one, two
/// channels of one name, two laws of instant displacement, ranges that have nothing in common.
[[nodiscard]] JoinedCorrection join_corrections(std::span<const CorrectionFile> files,
                                                const std::string& path);

}  // namespace raceway::files
