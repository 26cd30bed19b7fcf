#pragma once

#include <string>
#include <vector>

#include "record/note.h"

namespace raceway::session {

/// Receives the notes on an answer: the command prints them on stderr, Python issues warnings.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual void hear(const record::Note& note) = 0;
  /// Reports a file that a model file names and that the session reads.
  virtual void reads(const std::string&) {}

  void say(const record::Note& note) { hear(note); }
  void say(const std::vector<record::Note>& notes) {
    for (const record::Note& one : notes) hear(one);
  }
};

}  // namespace raceway::session
