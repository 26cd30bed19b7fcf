#include "c/message_text.h"

#include <cstring>
#include <exception>
#include <new>

#include "text/error.h"

namespace raceway::c {

void MessageText::add(std::string_view kind, const std::string& line) {
  if (!text_.empty()) text_ += '\n';
  text_.append(kind).append(line);
}

Reply::Reply(char* text, std::size_t size) noexcept : text_(text), size_(text ? size : 0) {
  put({});
}

void Reply::put(std::string_view text) noexcept {
  if (size_ == 0) return;
  std::size_t length = text.size();
  if (length >= size_) {
    length = size_ - 1;
    // Bytes 10xxxxxx go on with a character: it is cut before it begins.
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
  }
  if (length > 0) std::memcpy(text_, text.data(), length);
  text_[length] = '\0';
}

void explain(Reply& reply) noexcept {
  try {
    throw;
  } catch (const text::InputError& e) {
    reply.put(e.what());
  } catch (const std::bad_alloc&) {
    reply.put("raceway: not enough memory");
  } catch (const std::exception& e) {
    try {
      reply.put(std::string("raceway: ") + e.what());
    } catch (...) {
      reply.put(e.what());
    }
  } catch (...) {
    reply.put("raceway: an unknown error occurred");
  }
}

}  // namespace raceway::c
