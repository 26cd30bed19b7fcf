#include "files/spindle_record.h"

#include <utility>

#include "files/series_file.h"
#include "spindle/record_rows.h"

namespace raceway::files {

ReadOptions of_spindle(ReadOptions options) {
  options.of_spindle = true;
  return over_time(std::move(options));
}

record::Record read_spindle_record(const Source& source, const model::Spindle& spindle,
                                   const ReadOptions& options) {
  return read_series(source, spindle::measured_channels(spindle), {&record::speed},
                     of_spindle(options));
}

}  // namespace raceway::files
