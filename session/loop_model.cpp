#include "session/loop_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "files/model_parts.h"
#include "fit/several_records.h"
#include "loop/loop.h"
#include "session/bearing_in_loop.h"
#include "session/correction_in_loop.h"
#include "session/correction_input.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/names.h"

namespace raceway::session {
namespace {

files::ModelParts parts_of(const Source& file) {
  return file.text ? files::parts_of(*file.text) : files::parts_of_file(file.name);
}

/// The part that a column belongs to; of a file with one part that. A file with two asks.
Part part_of(const files::ModelParts& parts, const Source& file, const LoopOptions& options) {
  if (options.part != Part::any) return options.part;
  if (parts.displacements.empty()) return Part::bearing;
  if (!parts.bearing) return Part::correction;
  if (options.channel.empty())
    throw text::InputError(
        fmt::format("{}: the file has a bearing and the correction of {}: choose one with "
                    "--channel; --channel friction_torque_Nmm chooses the bearing",
                    file.name, text::listed(parts.displacements)),
        {.file = file.name, .key = "--channel"});
  return std::find(parts.displacements.begin(), parts.displacements.end(), options.channel) ==
                 parts.displacements.end()
             ? Part::bearing
             : Part::correction;
}

}  // namespace

LoopModel::About describe(Messages& messages, const Source& file, const LoopOptions& options) {
  const files::ModelParts parts = parts_of(file);
  const bool both = parts.bearing && !parts.displacements.empty();
  if (both && !file.text)  // standard input is read once
    return describe(messages, {text::input_name(file.name), text::read_text(file.name)}, options);
  LoopModel::About about;
  const auto add = [&](const auto& part, std::string name) {
    about.source = part.source;
    if (about.name.empty()) about.name = std::move(name);
    about.defaults.insert(about.defaults.end(), part.defaults.begin(), part.defaults.end());
    about.notes.insert(about.notes.end(), part.notes.begin(), part.notes.end());
  };
  if (parts.bearing || parts.displacements.empty()) {
    const files::ModelFile model =
        open_model(messages, file, Accepts::rig_or_shaft, options.defaults);
    add(model, model.model.name);
  }
  if (!parts.displacements.empty()) {
    const files::CorrectionFile corrections = open_corrections(messages, file, options.defaults);
    Names names;
    for (const correction::Model& m : corrections.models) names.push_back(m.name);
    add(corrections, text::listed(names));
  }
  return about;
}

std::shared_ptr<const fit::Subject> LoopModel::with_assumed_free(
    std::shared_ptr<const fit::Subject> prepared, const record::Record&, const Names&) const {
  return prepared;
}

Names records_apart(const fit::Subject& subject) {
  const auto* const several = dynamic_cast<const fit::SeveralRecords*>(&subject);
  if (!several || several->own().empty()) return {};
  return several->records();
}

verdict::Calibration refitted(Messages& messages, const fit::Subject& subject,
                              const record::Record& data, const Names& names) {
  verdict::Calibration found = loop::calibrate(subject, data);
  if (!found.converged())
    throw std::invalid_argument(
        fmt::format("the refit of {} does not converge", fmt::join(names, ", ")));
  messages.say(found.messages);
  return found;
}

std::unique_ptr<LoopModel> open_any_correction(Messages& messages, const Source& file,
                                               LoopOptions options) {
  const files::ModelParts parts = parts_of(file);
  if (options.channel.empty() && !parts.bearing && parts.displacements.size() > 1)
    options.channel = parts.displacements.front();
  return open_loop_model(messages, file, options);
}

std::unique_ptr<LoopModel> open_loop_model(Messages& messages, const Source& file,
                                           const LoopOptions& options, std::size_t place) {
  return part_of(parts_of(file), file, options) == Part::correction
             ? open_correction(messages, file, options)
             : open_bearing(messages, file, options, place);
}

}  // namespace raceway::session
