#pragma once

#include <string>

#include "control/plan.h"
#include "files/correction_file.h"
#include "record/record.h"
#include "session/messages.h"
#include "session/source.h"

namespace raceway::session {

/// Corrections as a program or a table that runs without this one.
struct ControlExport {
  control::ControlPlan plan{};  ///< with notes
  std::string text{};
  /// For linuxcnc: the lines that load the component and connect the axes, and the lines that end
  /// it.
  std::string hal{}, hal_shutdown{};
};

/// Checks the name of the output. Throws text::InputError: the name of a LinuxCNC component is the
/// name of its file.
void require_control_name(const std::string& format, const std::string& output);

/// HAL files of the component.
struct HalFiles {
  std::string start{}, shutdown{};
};
[[nodiscard]] HalFiles hal_files(const std::string& output);

/// Plan of a model file for a control, with a check record: `record`, or without it a synthetic
/// one. A table that export wrote is read back, with the record in it.
///
/// Throws text::InputError as the readers do, and for a record with a table.
[[nodiscard]] control::ControlPlan open_plan(Messages& messages, const Source& model,
                                             const Source* record = nullptr);

/// Refuses a plan with a displacement that is not to be used, or that predicts nothing. Throws
/// text::InputError, which says
/// why and how to export it all the same (--accept-untrusted).
void require_trust(const control::ControlPlan& plan);

/// `format`: python, c, csv or linuxcnc. `output`: the file that it will stand in, by which C and
/// HAL call it; empty or "-" without.
[[nodiscard]] ControlExport export_plan(control::ControlPlan plan, const std::string& format,
                                        const std::string& output);

}  // namespace raceway::session
