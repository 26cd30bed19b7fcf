#pragma once

#include <vector>

#include "record/record.h"
#include "session/messages.h"

namespace raceway::session {

/// Removes isolated readings of the channels `channels` from a record over time. An isolated
/// reading is far from the readings before and after it (fit/isolated_readings.h). Messages and the
/// notes of the record give the line numbers of the removed readings.
void leave_out_isolated(Messages& messages, record::Record& data,
                        const std::vector<const record::Channel*>& channels);

}  // namespace raceway::session
