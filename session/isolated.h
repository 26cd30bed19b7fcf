#pragma once

#include <vector>

#include "record/record.h"
#include "session/messages.h"

namespace raceway::session {

/// Removes isolated readings, which jump and return (fit/isolated_readings.h), from these channels
/// of a time record. Messages and the notes of the record give the line numbers of the removed
/// readings.
void leave_out_isolated(Messages& messages, record::Record& data,
                        const std::vector<const record::Channel*>& channels);

}  // namespace raceway::session
