#include "session/control_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "control/check_record.h"
#include "control/formats.h"
#include "control/table_reader.h"
#include "correction/trust.h"
#include "session/correction_input.h"
#include "session/reading.h"
#include "text/error.h"
#include "text/input_file.h"

namespace raceway::session {
namespace {

/// The name of the file without its end, as C and HAL have names.
std::string name_of(const std::string& output) {
  std::string name = std::filesystem::path(output).stem().string();
  if (output == "-" || output.empty()) name = "raceway_correction";
  for (char& c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9')) c = '_';
  }
  if (name.empty() || (name.front() >= '0' && name.front() <= '9') || name.front() == '_')
    name.insert(0, "correction_");
  return name;
}

control::ControlPlan plan_of(Messages& messages, const Source& model, const Source* record,
                             Reading reading) {
  const files::CorrectionFile file = open_corrections(messages, model);
  control::ControlPlan plan = control::control_plan(file.models, file.control, file.source);
  if (record) {
    reading.without_readings = true;  // only its inputs are exported
    const record::Record data = open_series(messages, reading.sources({*record}).front(),
                                            file.models, reading.options(file.columns));
    plan.check = control::check_of(plan, file.models, data);
    if (plan.check.rows.size() < data.rows())
      plan.notes.push_back(fmt::format("the check record contains the first {} of {} rows of {}",
                                       plan.check.rows.size(), data.rows(), data.source));
    for (std::string& note : control::coarse_sensors(plan, data))
      plan.notes.push_back(std::move(note));
    for (std::string& note : control::allow_still_sensors(plan, data))
      plan.notes.push_back(std::move(note));
  } else {
    plan.check = control::made_up_check(plan, file.models);
  }
  if (plan.check.rows.empty())
    plan.notes.push_back("the exported program contains no record, so it cannot check itself");
  return plan;
}

}  // namespace

void require_control_name(const std::string& format, const std::string& output) {
  if (format != "linuxcnc" || output.empty() || output == "-") return;
  const std::string name = name_of(output);
  const std::filesystem::path path(output);
  if (path.extension() != ".py" || path.stem() != name)
    throw text::InputError(
        fmt::format("--output {}: the file name is the name of the LinuxCNC component; use "
                    "letters, digits and _, and .py at the end, such as {}",
                    output, (path.parent_path() / (name + ".py")).string()),
        {.key = "--output"});
}

HalFiles hal_files(const std::string& output) {
  const std::string stem = std::filesystem::path(output).replace_extension().string();
  return {stem + ".hal", stem + "_shutdown.hal"};
}

control::ControlPlan open_plan(Messages& messages, const Source& model, const Source* record,
                               const Reading& reading) {
  const std::string text = model.text ? *model.text : text::peek_text(model.name);
  if (!control::is_control_table(text)) return plan_of(messages, model, record, reading);
  if (record)
    throw text::InputError(fmt::format("--record {}: {} is a table that export wrote, and it "
                                       "already contains its record; remove --record",
                                       record->name, model.name),
                           {.key = "--record"});
  return control::read_control_table(model.text ? *model.text : text::read_text(model.name),
                                     model.name);
}

void require_trust(const control::ControlPlan& plan) {
  for (const control::ControlAxis& axis : plan.axes)
    if (axis.trust == correction::name(correction::TrustLevel::do_not_use))
      throw text::InputError(
          fmt::format("{}: {}: {}. Use --accept-untrusted to export it nevertheless", plan.source,
                      axis.column, control::trust_line(axis)),
          {.file = plan.source, .key = "--accept-untrusted"});
  const auto predicts_nothing = [](const control::ControlAxis& axis) {
    return axis.sections.empty() && axis.elements.empty() && axis.feedthroughs.empty() &&
           axis.equations.empty() && axis.kinematics.empty();
  };
  if (std::all_of(plan.axes.begin(), plan.axes.end(), predicts_nothing))
    throw text::InputError(
        fmt::format(
            "{}: the model has neither a channel nor an effect, so it corrects nothing. Export the "
            "file that identify wrote, or use --accept-untrusted to export this model",
            plan.source),
        {.file = plan.source, .key = "--accept-untrusted"});
}

ControlExport export_plan(control::ControlPlan plan, const std::string& format,
                          const std::string& output) {
  ControlExport result;
  if (format == "linuxcnc") {
    control::count_in_whole_numbers(plan);
    const std::string name = name_of(output),
                      program = std::filesystem::path(output).filename().string();
    result.hal = control::control_hal(plan, name, program);
    result.hal_shutdown = control::control_hal_shutdown(plan, name, program);
  }
  result.text = format == "python"     ? control::control_python(plan)
                : format == "c"        ? control::control_c(plan, name_of(output))
                : format == "linuxcnc" ? control::control_linuxcnc(plan)
                                       : control::control_csv(plan);
  result.plan = std::move(plan);
  return result;
}

}  // namespace raceway::session
