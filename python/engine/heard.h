#pragma once

#include <string>
#include <vector>

#include "session/messages.h"

namespace raceway::python {

/// Keeps what is said beside an answer, for the caller to show.
struct Heard final : session::Messages {
  std::vector<std::string> note_lines, warning_lines;

  void note(const std::string& line) override { note_lines.push_back(line); }
  void warn(const std::string& line) override { warning_lines.push_back(line); }
};

}  // namespace raceway::python
