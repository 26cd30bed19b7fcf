#pragma once

#include <span>

#include "files/key.h"
#include "record/channel.h"

/// Keys of a correction by type of displacement; shared by the readers of corrections.
namespace raceway::files {

/// Returns the keys unchanged for a length. For an angle, "urad" replaces "um" in name and unit
/// (record::in_unit_of()). The returned keys live as long as the program.
[[nodiscard]] std::span<const Key> keys_of(const record::Channel* displacement,
                                           std::span<const Key> keys);

}  // namespace raceway::files
