#pragma once

#include <vector>

#include "record/record.h"
#include "session/messages.h"

namespace raceway::session {

/// Takes out readings of these channels that leave and return (fit/isolated_readings.h) from a
/// record over time; says their lines, and puts that into the notes of the record.
void leave_out_isolated(Messages& messages, record::Record& data,
                        const std::vector<const record::Channel*>& channels);

}  // namespace raceway::session
