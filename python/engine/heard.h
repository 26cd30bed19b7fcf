#pragma once

#include <vector>

#include "python/engine/note.h"
#include "record/note.h"
#include "session/messages.h"

namespace raceway::python {

/// Keeps the notes of an answer for the caller to show.
struct Heard final : session::Messages {
  std::vector<record::Note> notes, warnings;

  void hear(const record::Note& note) override {
    (note.kind() == record::NoteKind::note ? notes : warnings).push_back(note);
  }
};

}  // namespace raceway::python
