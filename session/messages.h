#pragma once

#include <string>
#include <vector>

#include "record/note.h"

namespace raceway::session {

/// Receives the notes on an answer: stderr of the command, the warnings of Python.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual void hear(const record::Note& note) = 0;
  /// A file that a model names and that is read, too.
  virtual void reads(const std::string&) {}

  void say(const record::Note& note) { hear(note); }
  void say(const std::vector<record::Note>& notes) {
    for (const record::Note& one : notes) hear(one);
  }
};

}  // namespace raceway::session
