#pragma once

#include <span>

#include "files/key.h"
#include "record/channel.h"

/// Keys of a correction for what its displacement is; shared by the readers of corrections.
namespace raceway::files {

/// The keys as they stand, which are written for a length; for an angle with "urad" in the place of
/// "um" in name and unit (record::in_unit_of()). They live as long as the program.
[[nodiscard]] std::span<const Key> keys_of(const record::Channel* displacement,
                                           std::span<const Key> keys);

}  // namespace raceway::files
