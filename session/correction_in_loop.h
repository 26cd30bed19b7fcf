#pragma once

#include <memory>

#include "session/loop_model.h"

namespace raceway::session {

/// Opens the correction of one displacement for the comparison with measurements. Throws
/// text::InputError under the conditions of open_loop_model(), and if the file has no correction of
/// this displacement.
[[nodiscard]] std::unique_ptr<LoopModel> open_correction(Messages& messages, const Source& file,
                                                         const LoopOptions& options);

}  // namespace raceway::session
