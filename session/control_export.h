#pragma once

#include <string>

#include "io/control_plan.h"
#include "io/correction_file.h"

namespace raceway::session {

/// Corrections as a program or a table that runs without this one.
struct ControlExport {
  io::ControlPlan plan{};  ///< with what is to be known of it
  std::string text{};
};

/// What a file of that name can be. Throws io::InputError: halcompile refuses a component of
/// LinuxCNC that is called otherwise than its file.
void require_control_name(const std::string& format, const std::string& output);

/// `format`: python, c, csv or linuxcnc. `output`: the file that it will stand in, by which C and
/// HAL call it; empty or "-" without.
[[nodiscard]] ControlExport export_corrections(const io::CorrectionFile& file,
                                               const std::string& format,
                                               const std::string& output);

}  // namespace raceway::session
