#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "record/note.h"
#include "session/messages.h"

namespace raceway::c {

/// Notes and warnings as a text, a line each.
class MessageText : public session::Messages {
 public:
  void hear(const record::Note& note) override {
    add(note.kind() == record::NoteKind::note ? "note: " : "warning: ", note.text);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void add(std::string_view kind, const std::string& line);
  std::string text_;
};

/// A text of the caller's, which is empty until something is put there.
class Reply {
 public:
  Reply(char* text, std::size_t size) noexcept;
  /// Stores the text up to the size of the buffer, cut between characters of UTF-8, with a final 0.
  void put(std::string_view text) noexcept;

 private:
  char* text_;
  std::size_t size_;
};

/// Puts the current exception into the reply, in the words of the command. Only for use in a
/// `catch`.
void explain(Reply& reply) noexcept;

/// The result of `work`; `failed` where it throws, and the reply says why.
template <typename Result, typename Work>
[[nodiscard]] Result guarded(Reply& reply, Result failed, const Work& work) noexcept {
  try {
    return work();
  } catch (...) {
    explain(reply);
    return failed;
  }
}

}  // namespace raceway::c
