#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// Opens a bearing on its rig, sets on a shaft, or a spindle for the loop of measurements and
/// model. Throws text::InputError like open_loop_model(), and if the model does not predict the
/// channel that the options name.
[[nodiscard]] std::unique_ptr<LoopModel> open_bearing(Messages& messages, const Source& file,
                                                      const LoopOptions& options,
                                                      std::size_t place);

}  // namespace raceway::session
