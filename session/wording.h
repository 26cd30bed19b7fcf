#pragma once

#include <string>

namespace raceway::session {

/// Naming of arguments in messages: by the flags of the command or by the arguments of a function.
enum class Wording { flags, arguments };

/// Returns "--moment" or "moment_Nm".
[[nodiscard]] inline std::string named(Wording wording, const char* flag, const char* argument) {
  return wording == Wording::flags ? flag : argument;
}

}  // namespace raceway::session
