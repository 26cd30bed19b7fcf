#pragma once

#include <span>

#include "files/key.h"
#include "record/channel.h"

/// Adapts the keys of a correction to displacements that are angles.
namespace raceway::files {

/// Returns the keys unchanged if the displacement is a length. For an angle, "urad" replaces "um"
/// in names and units (record::in_unit_of()). The returned keys are valid until the program ends.
[[nodiscard]] std::span<const Key> keys_of(const record::Channel* displacement,
                                           std::span<const Key> keys);

}  // namespace raceway::files
