#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "control/plan.h"

/// Corrections as programs and tables that run without this one.
///
/// All programs give the same numbers as `correct` and have flags of the same meaning: see
/// docs/control.md. `name` is the file name without extension, as an identifier.
namespace raceway::control {

/// A file of Python 2.7 and 3 that needs its standard library alone.
[[nodiscard]] std::string control_python(const ControlPlan& plan);

/// One header of C99 that needs math.h alone, in double or float.
[[nodiscard]] std::string control_c(const ControlPlan& plan, std::string_view name);

/// A component of LinuxCNC's HAL in Python.
[[nodiscard]] std::string control_linuxcnc(const ControlPlan& plan);

/// The lines of HAL that load the component `name` from the file `program` and connect it to the
/// axes.
[[nodiscard]] std::string control_hal(const ControlPlan& plan, std::string_view name,
                                      std::string_view program);
/// The lines of HAL that return the offset to 0 before LinuxCNC ends.
[[nodiscard]] std::string control_hal_shutdown(const ControlPlan& plan, std::string_view name,
                                               std::string_view program);

/// One number a row, with its unit and the part that it is of.
[[nodiscard]] std::string control_csv(const ControlPlan& plan);

}  // namespace raceway::control
