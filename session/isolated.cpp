#include "session/isolated.h"

#include <utility>

#include "fit/isolated_readings.h"

namespace raceway::session {

void leave_out_isolated(Messages& messages, record::Record& data,
                        const std::vector<const record::Channel*>& channels) {
  for (const record::Channel* channel : channels) {
    fit::Isolated isolated = fit::without_isolated_readings(data, *channel);
    if (!isolated.any()) continue;
    const record::Note said = record::note::left_out(isolated.statement(), {.file = data.source});
    messages.say(said);
    data = std::move(isolated.record);
    data.notes.push_back(said);
  }
}

}  // namespace raceway::session
