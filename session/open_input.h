#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "model/model_subject.h"
#include "record/record.h"
#include "report/report.h"
#include "session/messages.h"
#include "session/source.h"

namespace raceway::session {

/// Kinds of model that a command accepts.
enum class Accepts { rig, rig_or_shaft, shaft };

/// `count` adds a note with the number of default values in a model. `keep` adds no such note: use
/// `keep` for a command that lists the defaults, and if the same model is opened again.
enum class Defaults { count, keep };

/// Sends notes on a file as messages. Each text begins with the name of the file.
void say_of(Messages& messages, const std::string& source, std::vector<record::Note> notes);

/// Reads a model and adds notes on it. With Defaults::count, one note gives the number of default
/// values used. Throws text::InputError if the command does not accept this kind of model.
[[nodiscard]] files::ModelFile open_model(Messages& messages, const Source& model,
                                          Accepts accepts = Accepts::rig,
                                          Defaults defaults = Defaults::count);

/// Throws text::InputError for a model without an arrangement.
void require_shaft(const files::ModelFile& file);

/// Returns facts about the model of a file for a report page, with the numbers of the model `used`.
[[nodiscard]] report::ModelOfPage of_page(const files::ModelFile& file, const model::Model& used);

/// Warns if the file gives data of the bearing or the solver that the friction law does not use.
/// Such data have no effect on the friction torque.
void warn_of_ignored_data(Messages& messages, const files::ModelFile& file);

/// Reads measurements for a model. The speeds of a coast-down are converted to torques. Notes and
/// doubts appear as messages and in the notes of the record.
[[nodiscard]] record::Record open_data(Messages& messages, const Source& data,
                                       const model::ModelSubject& subject,
                                       const files::ReadOptions& options);

/// Reads one or several files and joins them to one record, otherwise like open_data(). Each file
/// must be suitable for the model. `model` is the file name in messages.
[[nodiscard]] record::Record open_records(Messages& messages, const std::vector<Source>& data,
                                          const std::string& model,
                                          const model::ModelSubject& subject,
                                          const files::ReadOptions& options);

/// Rethrows an error of `fit` about the data as text::InputError, with the names of the record and
/// of the model before the message.
[[noreturn]] void refuse_data(const std::string& model, const record::Record& data,
                              const std::invalid_argument& error);

/// Adds a message to a result if the torques of the record have an unknown scale factor.
void tell_of_scale(const record::Record& data, std::vector<record::Note>& messages);

}  // namespace raceway::session
