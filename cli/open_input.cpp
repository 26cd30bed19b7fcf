#include "cli/open_input.h"

#include <fmt/core.h>

#include "fit/coast_down.h"
#include "io/data_file.h"
#include "io/error.h"

namespace raceway::cli {

void tell(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
}

io::ModelFile open_model(const std::string& path) {
  io::ModelFile file = io::read_model(path);
  if (!file.defaults.empty()) {
    std::string line = path + ": defaults used:";
    for (const std::string& d : file.defaults) {
      const std::string shown = d.substr(0, d.find(" (default)"));
      line += (line.back() == ':' ? " " : ", ") + shown;
    }
    tell({line});
  }
  return file;
}

fit::DataSet open_data(const std::string& path, const fit::Rig& rig) {
  io::Measurement measurement = io::read_measurement(path, rig);
  if (auto* data = std::get_if<fit::DataSet>(&measurement)) {
    tell(data->notes);
    return std::move(*data);
  }
  try {
    fit::DataSet data =
        fit::coast_down_torque(std::get<fit::CoastDownRecord>(measurement), rig).data;
    tell(data.notes);
    return data;
  } catch (const std::invalid_argument& e) {
    throw io::InputError(path + ": " + e.what());
  }
}

}  // namespace raceway::cli
