#include "text/printable.h"

#include <fmt/format.h>

#include <iterator>

namespace raceway::text {
namespace {

/// How many bytes a control character takes here: none, one (C0, DEL) or two (C1: U+0080 to
/// U+009F).
std::size_t control_bytes(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return byte(0) == 0xc2 && text.size() > 1 && byte(1) >= 0x80 && byte(1) < 0xa0 ? 2 : 0;
}

}  // namespace

std::optional<std::string> control_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (const std::size_t bytes = control_bytes(text.substr(at)); bytes > 0 && text[at] != '\t')
      return fmt::format("U+{:04X}", static_cast<unsigned char>(text[at + bytes - 1]));
  return std::nullopt;
}

std::string printable(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t bytes = control_bytes(text.substr(at));
    if (bytes == 0 || kept.find(text[at]) != kept.npos) {
      out += text[at];
      continue;
    }
    at += bytes - 1;
    fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(text[at]));
  }
  return out;
}

}  // namespace raceway::text
