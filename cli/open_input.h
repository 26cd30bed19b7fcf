#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "fit/data_set.h"
#include "io/model_file.h"

namespace raceway::cli {

/// What a command works on.
enum class Subject { bearing, bearing_or_shaft, shaft };

/// Reads a model and names on stderr every default that was used. Throws io::InputError for a model
/// of another subject.
[[nodiscard]] io::ModelFile open_model(const std::string& path, Subject subject = Subject::bearing);

/// Reads measurements for a model, a coast-down turned into torque, and tells the notes on stderr.
[[nodiscard]] fit::DataSet open_data(const std::string& path, const fit::Rig& rig,
                                     const fit::Shaft* shaft = nullptr);

/// The same for whatever the model stands for.
[[nodiscard]] fit::DataSet open_data(const std::string& path, const fit::Model& model);

/// Puts the name of the model before what `fit` says of the data, and makes it an io::InputError.
[[noreturn]] void refuse_data(const std::string& model, const fit::DataSet& data,
                              const std::invalid_argument& error);

/// A line on stderr, behind all that stdout has so far.
void say(const std::string& line);

/// Lines on stderr, each behind `note: `.
void tell(const std::vector<std::string>& notes);

}  // namespace raceway::cli
