#pragma once

#include <string>

namespace raceway::session {

/// Selects the names of arguments in messages: flags of the command, or arguments of a function.
enum class Wording { flags, arguments };

/// Returns `flag`, such as "--moment", for Wording::flags, and `argument`, such as "moment_Nm", for
/// Wording::arguments.
[[nodiscard]] inline std::string named(Wording wording, const char* flag, const char* argument) {
  return wording == Wording::flags ? flag : argument;
}

}  // namespace raceway::session
