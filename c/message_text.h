#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "record/note.h"
#include "session/messages.h"

namespace raceway::c {

/// Text of notes and warnings, one per line.
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

/// Text buffer that the caller provides. The constructor stores an empty text.
class Reply {
 public:
  Reply(char* text, std::size_t size) noexcept;
  /// Stores the text with a terminating zero byte. A text that is longer than the buffer is cut
  /// between two UTF-8 characters.
  void put(std::string_view text) noexcept;

 private:
  char* text_;
  std::size_t size_;
};

/// Stores the message of the current exception in the reply. Call this function only in a `catch`
/// block.
void explain(Reply& reply) noexcept;

/// Returns the result of `work`. If `work` throws, returns `failed` and stores the message in the
/// reply.
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
