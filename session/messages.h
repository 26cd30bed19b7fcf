#pragma once

#include <string>
#include <vector>

namespace raceway::session {

/// Who hears what is to be said beside an answer: stderr of the command, the warnings of Python.
class Messages {
 public:
  virtual ~Messages() = default;
  /// What is good to know.
  virtual void note(const std::string& line) = 0;
  /// What makes a result doubtful.
  virtual void warn(const std::string& line) = 0;
  /// A file that a model names and that is read, too.
  virtual void reads(const std::string&) {}

  void notes(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) note(line);
  }
  void warnings(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) warn(line);
  }
};

}  // namespace raceway::session
