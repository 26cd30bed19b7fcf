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
  control::ControlPlan plan{};  ///< with what is to be known of it
  std::string text{};
  /// Of linuxcnc: the lines that load it and connect the axes, and those that end it.
  std::string hal{}, hal_shutdown{};
};

/// What a file of that name can be. Throws text::InputError: a component of LinuxCNC is called as
/// its file.
void require_control_name(const std::string& format, const std::string& output);

/// The files with the lines of HAL that stand beside the component.
struct HalFiles {
  std::string start{}, shutdown{};
};
[[nodiscard]] HalFiles hal_files(const std::string& output);

/// What a control runs of a model file, with a record to hold it to: `record`, or without it one
/// that is made up. A table that export wrote is read back, with the record that is in it.
///
/// Throws text::InputError as the readers do, and for a record with a table.
[[nodiscard]] control::ControlPlan open_plan(Messages& messages, const Source& model,
                                             const Source* record = nullptr);

/// Refuses a plan with a displacement that is not to be used. Throws text::InputError, which says
/// why and how to export it all the same (--accept-untrusted).
void require_trust(const control::ControlPlan& plan);

/// `format`: python, c, csv or linuxcnc. `output`: the file that it will stand in, by which C and
/// HAL call it; empty or "-" without.
[[nodiscard]] ControlExport export_plan(control::ControlPlan plan, const std::string& format,
                                        const std::string& output);

}  // namespace raceway::session
