#pragma once

#include <vector>

#include "python/engine/note.h"
#include "record/note.h"
#include "session/messages.h"

namespace raceway::python {

/// Stores the notes and warnings of a call, so that the caller can show them.
struct Heard final : session::Messages {
  std::vector<record::Note> notes, warnings;

  void hear(const record::Note& note) override {
    (note.kind() == record::NoteKind::note ? notes : warnings).push_back(note);
  }
};

}  // namespace raceway::python
