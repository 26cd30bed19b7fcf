#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "control/plan.h"

/// Writes corrections as programs and tables for a control on which raceway is not installed.
///
/// If all inputs are valid and within the ranges of the training data, the programs compute the
/// same displacements as `correct`, except for the differences that ControlPlan::notes lists. The
/// flags with which a program reports faults are equal in all programs: see docs/control.md. `name`
/// is the name of the exported file without extension. The name must be a valid identifier of the
/// target language.
namespace raceway::control {

/// Returns a program for Python 2.7 and 3. The program needs only the standard library.
[[nodiscard]] std::string control_python(const ControlPlan& plan);

/// Returns a C99 header, for double or float. The header needs only math.h.
[[nodiscard]] std::string control_c(const ControlPlan& plan, std::string_view name);

/// Returns a Python component for HAL, the hardware abstraction layer of LinuxCNC.
[[nodiscard]] std::string control_linuxcnc(const ControlPlan& plan);

/// Returns the HAL commands that load the component `name` from the file `program` and connect the
/// component to the machine axes. Throws InputError if the plan has no axis letter, such as z, for
/// a displacement.
[[nodiscard]] std::string control_hal(const ControlPlan& plan, std::string_view name,
                                      std::string_view program);
/// Returns the HAL commands that move the axis offsets back to 0 before LinuxCNC ends.
[[nodiscard]] std::string control_hal_shutdown(const ControlPlan& plan, std::string_view name,
                                               std::string_view program);

/// Returns the table of coefficients (CSV): each row contains a number, its unit, and the name of
/// the part of the correction that uses the number.
[[nodiscard]] std::string control_csv(const ControlPlan& plan);

}  // namespace raceway::control
