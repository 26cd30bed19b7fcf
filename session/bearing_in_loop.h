#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// A bearing on its rig, the sets on a shaft or a spindle, for the loop. Throws text::InputError as
/// open_loop_model(), and for a channel that it does not predict.
[[nodiscard]] std::unique_ptr<LoopModel> open_bearing(Messages& messages, const Source& file,
                                                      const LoopOptions& options,
                                                      std::size_t place);

}  // namespace raceway::session
