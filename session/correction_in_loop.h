#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// The correction of one displacement, for the loop. Throws text::InputError as open_loop_model(),
/// and for a displacement that the file does not model.
[[nodiscard]] std::unique_ptr<LoopModel> open_correction(Messages& messages, const Source& file,
                                                         const LoopOptions& options);

}  // namespace raceway::session
