#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "io/model_file.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::cli {

/// Which models a command takes.
enum class Accepts { rig, rig_or_shaft, shaft };

/// Reads a model and names on stderr every default that was used. Throws io::InputError for a model
/// that the command does not take.
[[nodiscard]] io::ModelFile open_model(const std::string& path, Accepts accepts = Accepts::rig);

/// Warns where the file says something of its bearing or solver that changes no digit of the
/// friction torque: the law takes no account of it.
void warn_of_ignored_data(const io::ModelFile& file);

/// Reads measurements for a model, a coast-down turned into torque, and tells the notes on stderr.
[[nodiscard]] record::Record open_data(const std::string& path, const model::ModelSubject& subject,
                                       const io::ReadOptions& options);

/// The same of one file or several, which are joined to one record. Each must be of what the model
/// stands for; `model` is its file, for messages.
[[nodiscard]] record::Record open_records(const std::vector<std::string>& paths,
                                          const std::string& model,
                                          const model::ModelSubject& subject,
                                          const io::ReadOptions& options);

/// Puts the name of the model before what `fit` says of the data, and makes it an io::InputError.
[[noreturn]] void refuse_data(const std::string& model, const record::Record& data,
                              const std::invalid_argument& error);

/// Adds to the messages of a result that its torques have an unknown factor, where the record says
/// so.
void tell_of_scale(const record::Record& data, std::vector<std::string>& messages);

/// A note where a temperature of the flag --temperature looks like kelvin.
void tell_of_kelvin(const std::vector<double>& temperatures_C);

/// A line on stderr, behind all that stdout has so far.
void say(const std::string& line);

/// A line on stderr behind `warning: `: an answer that is not what a user would take it for.
void warn(const std::string& line);

/// Lines on stderr, each behind `note: `.
void tell(const std::vector<std::string>& notes);

}  // namespace raceway::cli
