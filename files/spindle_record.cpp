#include "files/spindle_record.h"

#include <algorithm>
#include <utility>

#include "files/series_file.h"
#include "record/series_channel.h"
#include "spindle/record_rows.h"

namespace raceway::files {
namespace {

/// True where a speed, a load, a heat or the coolant changes.
bool settings_change(const record::Record& record) {
  return std::any_of(record.columns.begin(), record.columns.end(), [&](const record::Column& c) {
    return c.channel->is_input() && record::course_of(*c.channel) == record::Course::held &&
           record.varies(*c.channel);
  });
}

}  // namespace

ReadOptions of_spindle(ReadOptions options) {
  options.of_spindle = true;
  return over_time(std::move(options));
}

record::Record read_spindle_record(const Source& source, const model::Spindle& spindle,
                                   const ReadOptions& options) {
  record::Record record = read_series(source, spindle::measured_channels(spindle), {&record::speed},
                                      of_spindle(options));
  if (!options.columns.settings_hold && settings_change(record))
    record.notes.push_back(record::note::assumed(
        "the settings of a row are taken to hold since the row before it; settings_hold = \"until "
        "row\" in [columns] confirms that, \"from row\" is for a programme of events",
        {.key = "settings_hold"}));
  return record;
}

}  // namespace raceway::files
