#include "session/control_export.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "io/control_files.h"
#include "io/error.h"

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

}  // namespace

void require_control_name(const std::string& format, const std::string& output) {
  if (format != "linuxcnc" || output.empty() || output == "-") return;
  const std::string name = name_of(output);
  const std::filesystem::path path(output);
  if (path.extension() != ".comp" || path.stem() != name)
    throw io::InputError(
        fmt::format(
            "--output {}: a component of LinuxCNC has the name of its file, letters, digits "
            "and _ with .comp at the end: {}",
            output, (path.parent_path() / (name + ".comp")).string()),
        {.key = "--output"});
}

ControlExport export_corrections(const io::CorrectionFile& file, const std::string& format,
                                 const std::string& output) {
  ControlExport result{.plan = io::control_plan(file.models, file.source)};
  const io::ControlPlan& plan = result.plan;
  result.text = format == "python"     ? io::control_python(plan)
                : format == "c"        ? io::control_c(plan, name_of(output))
                : format == "linuxcnc" ? io::control_linuxcnc(plan, name_of(output))
                                       : io::control_csv(plan);
  return result;
}

}  // namespace raceway::session
