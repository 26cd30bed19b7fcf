#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// Opens the model of a bearing on its rig, of sets on a shaft, or of a spindle for the comparison
/// with measurements. Throws text::InputError under the conditions of open_loop_model(), and if the
/// model does not predict the channel in `options`.
[[nodiscard]] std::unique_ptr<LoopModel> open_bearing(Messages& messages, const Source& file,
                                                      const LoopOptions& options,
                                                      std::size_t place);

}  // namespace raceway::session
