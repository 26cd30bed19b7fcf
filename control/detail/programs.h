#pragma once

#include <string_view>

/// Program templates of a plan, from program.*.in; see text.h.
namespace raceway::control {

extern const std::string_view python_program, c_program, python_main, linuxcnc_main;

}  // namespace raceway::control
