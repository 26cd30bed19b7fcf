#pragma once

#include <string_view>

/// Templates of the exported programs, made from control/*.in by CMake. filled() inserts the
/// values.
namespace raceway::control {

extern const std::string_view python_program, c_program, python_main, linuxcnc_main;

}  // namespace raceway::control
