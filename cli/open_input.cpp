#include "cli/open_input.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include "io/data_file.h"
#include "io/error.h"

namespace raceway::cli {

void say(const std::string& line) {
  std::fflush(stdout);  // a log of both keeps the order
  fmt::print(stderr, "{}\n", line);
}

void tell(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) say("note: " + note);
}

void refuse_data(const std::string& model, const record::Record& data,
                 const std::invalid_argument& error) {
  std::string message = error.what();
  if (const std::string place = data.source + ": "; message.starts_with(place))
    message.erase(0, place.size());
  throw io::InputError(fmt::format("{} with {}: {}", data.source, model, message));
}

io::ModelFile open_model(const std::string& path, Accepts accepts) {
  io::ModelFile file = [&] {
    try {
      return io::read_model(path);
    } catch (const io::InputError& e) {
      if (!path.ends_with(".csv")) throw;
      throw io::InputError(std::string(e.what()) + "\n" + path +
                           ": stands where a model (TOML) is expected");
    }
  }();
  if (file.model.shaft && accepts == Accepts::rig)
    throw io::InputError(
        path +
        ": has an [arrangement]: this command works on a single bearing on a rig; "
        "displacement, solve, table, check, compare, diagnose, add and calibrate with data work on "
        "a shaft");
  if (!file.model.shaft && accepts == Accepts::shaft)
    throw io::InputError(path +
                         ": has no [arrangement]: a shaft position needs one, with layout, "
                         "front, rear and preload_N");
  if (!file.defaults.empty()) {
    std::string line = path + ": defaults used:";
    for (const std::string& d : file.defaults) {
      const std::string shown = d.substr(0, d.find(" (default)"));
      line += (line.back() == ':' ? " " : ", ") + shown;
    }
    tell({line});
  }
  for (const std::string& note : file.notes) tell({path + ": " + note});
  return file;
}

record::Record open_data(const std::string& path, const model::ModelSubject& subject) {
  if (path.ends_with(".toml"))
    throw io::InputError(path + ": stands where measurements (CSV) are expected");
  record::Record data = io::read_record(path, subject);
  tell(data.notes);
  return data;
}

void tell_of_scale(const record::Record& data, std::vector<std::string>& messages) {
  if (data.up_to_a_factor)
    messages.emplace_back(
        "the inertia is unknown: all torques, f0, z and sizes in N mm have one common factor that "
        "this record does not tell; the result rests on the shape alone");
}

record::Record open_records(const std::vector<std::string>& paths, const std::string& model,
                            const model::ModelSubject& subject) {
  if (paths.size() == 1) return open_data(paths.front(), subject);
  std::vector<record::Record> records;
  for (const std::string& path : paths) {
    records.push_back(open_data(path, subject));
    try {
      subject.require(records.back());
    } catch (const std::invalid_argument& e) {
      refuse_data(model, records.back(), e);
    }
  }
  for (const fit::Measured& m : subject.measured()) {
    const auto declares = [&](const record::Record& r) { return r.deviation_of(*m.channel); };
    if (std::any_of(records.begin(), records.end(), declares) &&
        !std::all_of(records.begin(), records.end(), declares))
      tell(
          {fmt::format("std_{} is not in every file: it counts in none, and the noise is found "
                       "from the rows",
                       m.channel->key_unit())});
  }
  try {
    return record::joined(std::move(records));
  } catch (const std::invalid_argument& e) {
    throw io::InputError(e.what());
  }
}

}  // namespace raceway::cli
