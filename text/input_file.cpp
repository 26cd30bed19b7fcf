#include "text/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "text/error.h"
#include "text/text_encoding.h"

namespace raceway::text {
namespace {

constexpr std::size_t longest_input = 4'000'000'000;
constexpr const char* too_long =
    "the file is larger than 4 GB, the largest size that the program reads";

}  // namespace

namespace {

/// Tells the second file named `-` from the first.
bool take_standard_input() {
  static std::atomic<bool> taken = false;
  return !taken.exchange(true);
}

/// A named pipe, once a program writes into it. Opened as a file it would wait for one for ever, as
/// the second time when it is read twice.
std::FILE* open_pipe(const std::string& path) {
  const auto fail = [&](std::string_view what) {
    return InputError(fmt::format("{}: {}", path, what), {.file = path});
  };
  const int pipe = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (pipe < 0) throw fail(std::string("cannot be read: ") + std::strerror(errno));
  std::FILE* const file = ::fdopen(pipe, "rb");
  if (!file) {
    ::close(pipe);
    throw fail(std::string("cannot be read: ") + std::strerror(errno));
  }
  constexpr auto pause = std::chrono::milliseconds(20);
  constexpr auto patience = std::chrono::seconds(5);
  unsigned char first = 0;
  for (auto waited = std::chrono::milliseconds(0);; waited += pause) {
    const auto count = ::read(pipe, &first, 1);
    if (count < 0 && errno != EAGAIN && errno != EINTR) {
      std::fclose(file);
      throw fail(std::string("cannot be read: ") + std::strerror(errno));
    }
    if (count != 0) {  // a byte, or a program that has written none yet
      (void)::fcntl(pipe, F_SETFL, ::fcntl(pipe, F_GETFL) & ~O_NONBLOCK);
      if (count == 1) (void)std::ungetc(first, file);
      return file;
    }
    if (waited >= patience) {
      std::fclose(file);
      throw fail("is a pipe, and no program writes to it; name a file instead");
    }
    std::this_thread::sleep_for(pause);
  }
}

/// To be read and, unless it is standard input, closed.
std::FILE* open(const std::string& path) {
  if (path == "-") {
    if (!take_standard_input())
      throw InputError(
          "-: standard input can be used for one input only; name a file for the other input",
          {.file = "-"});
    return stdin;
  }
  std::error_code ignored;
  if (path.empty()) throw InputError("the name of an input file is empty");
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(path + ": no such file", {.file = path});
  if (std::filesystem::is_directory(status))
    throw InputError(path + ": is a directory; name a file", {.file = path});

  if (status.type() == std::filesystem::file_type::fifo) return open_pipe(path);
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (!file) throw InputError(path + ": cannot be read: " + std::strerror(errno), {.file = path});
  return file;
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

namespace {

std::string read_now(const std::string& path, bool* byte_order_mark) {
  const auto close = [](std::FILE* opened) {
    if (opened != stdin) std::fclose(opened);
  };
  const std::unique_ptr<std::FILE, decltype(close)> file(open(path), close);
  std::string text;
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored && size > longest_input)
    throw InputError(input_name(path) + ": " + too_long, {.file = input_name(path)});
  if (!ignored && path != "-") text.reserve(static_cast<std::size_t>(size) + 1);
  bool utf16 = false;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
    const std::string_view piece(buffer, count);
    if (text.empty()) {
      if (const std::string_view kind = binary_kind(piece); !kind.empty())
        throw InputError(fmt::format("{}: {}", input_name(path), kind), {.file = input_name(path)});
      utf16 = is_utf16(piece);
    }
    // At once: /dev/zero does not end.
    if (!utf16 && piece.find('\0') != piece.npos)
      throw InputError(input_name(path) + ": the file contains NUL bytes, so it is not a text file",
                       {.file = input_name(path)});
    if (text.size() + count > longest_input)
      throw InputError(input_name(path) + ": " + too_long, {.file = input_name(path)});
    text.append(buffer, count);
  }
  if (std::ferror(file.get()))
    throw InputError(input_name(path) + ": cannot be read: " + std::strerror(errno),
                     {.file = input_name(path)});

  if (utf16) text = utf8_from_utf16(text, input_name(path));
  if (text.find('\0') != std::string::npos)
    throw InputError(input_name(path) + ": the file contains NUL bytes, so it is not a text file",
                     {.file = input_name(path)});
  const bool marked = text.starts_with("\xef\xbb\xbf");
  if (marked) text.erase(0, 3);
  if (byte_order_mark) *byte_order_mark = marked;
  return text;
}

/// Of standard input, which cannot be read again.
struct Peeked {
  std::string text;
  bool marked = false;
};
std::optional<Peeked>& peeked() {
  static std::optional<Peeked> of_standard_input;
  return of_standard_input;
}

}  // namespace

std::string read_text(const std::string& path, bool* byte_order_mark) {
  if (path != "-" || !peeked()) return read_now(path, byte_order_mark);
  const Peeked kept = std::move(*peeked());
  peeked().reset();
  if (byte_order_mark) *byte_order_mark = kept.marked;
  return kept.text;
}

std::string peek_text(const std::string& path) {
  if (path != "-") return read_now(path, nullptr);
  if (!peeked()) {
    Peeked now;
    now.text = read_now(path, &now.marked);
    peeked() = std::move(now);
  }
  return peeked()->text;
}

}  // namespace raceway::text
