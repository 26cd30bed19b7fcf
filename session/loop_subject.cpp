#include "session/loop_subject.h"

#include <fmt/format.h>

#include <algorithm>

#include "fit/several_records.h"
#include "io/error.h"
#include "io/subject.h"

namespace raceway::session {

std::shared_ptr<const fit::Subject> PerRecord::subject(const model::Model& model,
                                                       const record::Record& data) const {
  if (model.spindle) {
    if (!names.empty())
      throw io::InputError(
          "--per-record: a spindle has one set of numbers for all its records; calibrate with each "
          "record by itself",
          {.key = "--per-record"});
    return io::make_subject(model);  // runs of all records are simulated by themselves
  }
  if (data.parts.empty()) {
    if (!names.empty())
      throw io::InputError(fmt::format("--per-record {}: {} is one record, whose parameters are "
                                       "all its own; name two files of "
                                       "measurements or more",
                                       fmt::join(names, ","), data.source),
                           {.file = data.source, .key = "--per-record"});
    return io::make_subject(model);
  }
  // Free in the model too, so that an effect of which a number is named counts as one to be learnt.
  model::Model wanted = model;
  wanted.free = io::make_subject(model)->free();
  for (const std::string& name : names)
    if (std::find(wanted.free.begin(), wanted.free.end(), name) == wanted.free.end())
      wanted.free.push_back(name);
  try {
    (void)fit::find_parameters(*io::make_subject(model), names);
    return std::make_shared<fit::SeveralRecords>(io::make_subject(wanted), data, names);
  } catch (const std::invalid_argument& e) {
    throw io::InputError(std::string("--per-record: ") + e.what(), {.key = "--per-record"});
  }
}

}  // namespace raceway::session
