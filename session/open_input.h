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

/// Models that a command accepts.
enum class Accepts { rig, rig_or_shaft, shaft };

/// Choice whether opening a model counts its defaults in a note. A command that lists them does not
/// count them, nor does a second opening of the same model.
enum class Defaults { count, keep };

/// Says notes on a file, whose name begins each text.
void say_of(Messages& messages, const std::string& source, std::vector<record::Note> notes);

/// Reads a model, counts the defaults that were used, and gives notes on it. Throws
/// text::InputError for a model that is not accepted.
[[nodiscard]] files::ModelFile open_model(Messages& messages, const Source& model,
                                          Accepts accepts = Accepts::rig,
                                          Defaults defaults = Defaults::count);

/// Facts on a model for a page, with the numbers that it was used with.
[[nodiscard]] report::ModelOfPage of_page(const files::ModelFile& file, const model::Model& used);

/// Warns where the file says something of its bearing or solver that changes no digit of the
/// friction torque: the law takes no account of it.
void warn_of_ignored_data(Messages& messages, const files::ModelFile& file);

/// Reads measurements for a model, a coast-down turned into torque. Notes and doubts are messages
/// and stand in the notes of the record.
[[nodiscard]] record::Record open_data(Messages& messages, const Source& data,
                                       const model::ModelSubject& subject,
                                       const files::ReadOptions& options);

/// Reads one file or several, which are joined to one record, otherwise as open_data(). Each must
/// fit the subject of the model; `model` is its file, for messages.
[[nodiscard]] record::Record open_records(Messages& messages, const std::vector<Source>& data,
                                          const std::string& model,
                                          const model::ModelSubject& subject,
                                          const files::ReadOptions& options);

/// Puts the name of the model before what `fit` says of the data, and makes it an text::InputError.
[[noreturn]] void refuse_data(const std::string& model, const record::Record& data,
                              const std::invalid_argument& error);

/// Adds to the messages of a result that its torques have an unknown factor, where the record says
/// so.
void tell_of_scale(const record::Record& data, std::vector<record::Note>& messages);

}  // namespace raceway::session
