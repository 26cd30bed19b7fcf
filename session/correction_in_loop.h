#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// Opens the correction of one displacement for the comparison with measurements.
/// LoopOptions::channel names the displacement. Throws the same exceptions as open_loop_model(),
/// and text::InputError if the file has no correction of this displacement.
[[nodiscard]] std::unique_ptr<LoopModel> open_correction(Messages& messages, const Source& file,
                                                         const LoopOptions& options);

}  // namespace raceway::session
