#pragma once

#include <string>
#include <vector>

#include "record/note.h"

namespace raceway::session {

/// Receives the notes and warnings of a calculation. The command-line program prints these messages
/// on stderr. The Python package stores the notes in the result and issues the warnings as Python
/// warnings.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual void hear(const record::Note& note) = 0;
  /// Receives the name of a file that the program reads because a model file names it.
  virtual void reads(const std::string&) {}

  void say(const record::Note& note) { hear(note); }
  void say(const std::vector<record::Note>& notes) {
    for (const record::Note& one : notes) hear(one);
  }
};

}  // namespace raceway::session
