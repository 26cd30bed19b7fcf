#pragma once

#include <string>

#include "control/plan.h"
#include "files/correction_file.h"
#include "record/record.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// Exported corrections: a program that runs without raceway, or a table of coefficients.
struct ControlExport {
  control::ControlPlan plan{};  ///< exported corrections, and notes for the user
  std::string text{};
  /// Texts of two HAL files (hardware abstraction layer of LinuxCNC) for the format linuxcnc; empty
  /// for other formats. `hal` loads the component and connects the axes, and `hal_shutdown` stops
  /// the component.
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
/// with the displacements that `raceway correct` predicts. The inputs come from `record`. If
/// `record` is null, the function generates the inputs. Instead of a model file, `model` may be an
/// exported table of coefficients, which already contains a check record. `reading` contains the
/// options for reading `record`.
///
/// Throws text::InputError for a file that cannot be read, and if both an exported table and a
/// record are given.
[[nodiscard]] control::ControlPlan open_plan(Messages& messages, const Source& model,
                                             const Source* record = nullptr,
                                             const Reading& reading = {});

/// Throws text::InputError if the trust in a correction is `do_not_use`, or if no correction of the
/// plan has a channel, an effect or a kinematic law. The message gives the reason. The message also
/// names the flag --accept-untrusted, which allows the export.
void require_trust(const control::ControlPlan& plan);

/// Exports a plan. `format` is python, c, csv or linuxcnc. `output` is the file name; empty or "-"
/// if there is no file. The file name without its ending is also the prefix of the C functions and
/// the name of the HAL component.
[[nodiscard]] ControlExport export_plan(control::ControlPlan plan, const std::string& format,
                                        const std::string& output);

}  // namespace raceway::session
