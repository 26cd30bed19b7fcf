#pragma once

#include <string>
#include <vector>

#include "fit/data_set.h"
#include "io/model_file.h"

namespace raceway::cli {

/// Reads a model and names on stderr every default that was used.
[[nodiscard]] io::ModelFile open_model(const std::string& path);

/// Reads measurements for a model, a coast-down turned into torque, and tells the notes on stderr.
[[nodiscard]] fit::DataSet open_data(const std::string& path, const fit::Rig& rig);

/// Lines on stderr, each behind `note: `.
void tell(const std::vector<std::string>& notes);

}  // namespace raceway::cli
