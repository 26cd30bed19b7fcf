#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// Opens a model for the comparison with measurements: a bearing on its rig, bearing sets on a
/// shaft, or a spindle. `place` is the index of the model in a comparison of several models. Throws
/// the same exceptions as open_loop_model(), and text::InputError if the model does not predict the
/// measured channel LoopOptions::channel.
[[nodiscard]] std::unique_ptr<LoopModel> open_bearing(Messages& messages, const Source& file,
                                                      const LoopOptions& options,
                                                      std::size_t place);

}  // namespace raceway::session
