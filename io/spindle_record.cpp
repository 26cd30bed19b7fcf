#include "io/spindle_record.h"

#include <utility>

#include "io/series_file.h"
#include "spindle/record_rows.h"

namespace raceway::io {
namespace {

ReadOptions of_spindle(ReadOptions options) {
  options.of_spindle = true;
  return options;
}

}  // namespace

record::Record read_spindle_record(const std::string& path, const model::Spindle& spindle,
                                   const ReadOptions& options) {
  return read_series(path, spindle::measured_channels(spindle), {&record::speed},
                     of_spindle(options));
}

record::Record parse_spindle_record(std::string text, const std::string& source,
                                    const model::Spindle& spindle, const ReadOptions& options) {
  return parse_series(std::move(text), source, spindle::measured_channels(spindle),
                      {&record::speed}, of_spindle(options));
}

}  // namespace raceway::io
