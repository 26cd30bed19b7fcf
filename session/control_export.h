#pragma once

#include <string>

#include "control/plan.h"
#include "files/correction_file.h"
#include "record/record.h"
#include "session/messages.h"
#include "session/source.h"

namespace raceway::session {

/// Corrections exported as a program that runs without raceway, or as a table for such a program.
struct ControlExport {
  control::ControlPlan plan{};  ///< corrections to export, with notes
  std::string text{};
  /// For linuxcnc: HAL lines that load the component and connect the axes, and lines that stop it.
  std::string hal{}, hal_shutdown{};
};

/// Throws text::InputError if the format is linuxcnc and the output file is not a valid component
/// name with the ending .py.
void require_control_name(const std::string& format, const std::string& output);

/// Names of the HAL files that start and stop the component of LinuxCNC.
struct HalFiles {
  std::string start{}, shutdown{};
};
[[nodiscard]] HalFiles hal_files(const std::string& output);

/// Opens a model file for the export to a machine control, and adds a check record: rows of inputs
/// with the displacements that `correct` predicts. The inputs come from `record`, or are synthetic
/// if `record` is null. `model` may also be an exported table, which contains its check record.
///
/// Throws text::InputError for a file that cannot be read, and for a table that is given together
/// with a record.
[[nodiscard]] control::ControlPlan open_plan(Messages& messages, const Source& model,
                                             const Source* record = nullptr);

/// Throws text::InputError if the trust in the correction of a displacement is `do_not_use`, or if
/// no correction of the plan has a channel, an effect or a kinematic law. The message gives the
/// reason and the flag that allows the export (--accept-untrusted).
void require_trust(const control::ControlPlan& plan);

/// Exports a plan. `format` is python, c, csv or linuxcnc. `output` is the file name; empty or "-"
/// if there is no file. The file name without its ending is also the prefix of the C functions and
/// the name of the HAL component.
[[nodiscard]] ControlExport export_plan(control::ControlPlan plan, const std::string& format,
                                        const std::string& output);

}  // namespace raceway::session
