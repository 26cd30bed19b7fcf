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

/// Treatment of default values in a model. `count` adds a note with the number of default values.
/// `keep` adds no note, for commands that list the default values or open the model again.
enum class Defaults { count, keep };

/// Sends notes about a file to `messages`. Each note begins with `source`, the name of the file.
void say_of(Messages& messages, const std::string& source, std::vector<record::Note> notes);

/// Reads a model and sends notes to `messages`. With Defaults::count, one note gives the number of
/// default values used. Throws text::InputError if the command does not accept this kind of model.
[[nodiscard]] files::ModelFile open_model(Messages& messages, const Source& model,
                                          Accepts accepts = Accepts::rig,
                                          Defaults defaults = Defaults::count);

/// Throws text::InputError for a model without bearing sets on a shaft ([arrangement]).
void require_shaft(const files::ModelFile& file);

/// Returns the description of a model for a report page. The name and the default values come from
/// `file`. `used` is the model of the calculation, for example after a fit.
[[nodiscard]] report::ModelOfPage of_page(const files::ModelFile& file, const model::Model& used);

/// Warns if the file gives keys of the bearing or the solver that do not change the friction
/// torque, because the friction law does not use them.
void warn_of_ignored_data(Messages& messages, const files::ModelFile& file);

/// Reads measurements for a model. For a coast-down, the friction torques are computed from the
/// speeds. Notes on the data appear as messages and in the notes of the record.
[[nodiscard]] record::Record open_data(Messages& messages, const Source& data,
                                       const model::ModelSubject& subject,
                                       const files::ReadOptions& options);

/// Reads one or several files like open_data(), and joins them to one record. Each file must be
/// suitable for the model. `model` is the file name of the model, for messages.
[[nodiscard]] record::Record open_records(Messages& messages, const std::vector<Source>& data,
                                          const std::string& model,
                                          const model::ModelSubject& subject,
                                          const files::ReadOptions& options);

/// Throws text::InputError for a record that is not suitable for a model. The message contains the
/// names of model and record, and the message of `error`.
[[noreturn]] void refuse_data(const std::string& model, const record::Record& data,
                              const std::invalid_argument& error);

/// Adds a note if the torques of the record are known only up to a common factor, as in a
/// coast-down of a rotor with unknown inertia.
void tell_of_scale(const record::Record& data, std::vector<record::Note>& messages);

}  // namespace raceway::session
