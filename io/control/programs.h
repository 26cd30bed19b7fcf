#pragma once

#include <string_view>

/// The programs that a plan is put into, from io/control/program.*.in; see text.h; not for other
/// code.
namespace raceway::io {

extern const std::string_view python_program, c_program, python_main, linuxcnc_main;

}  // namespace raceway::io
