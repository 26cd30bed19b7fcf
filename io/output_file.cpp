#include "io/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "io/error.h"

namespace raceway::io {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A terminal, a pipe or /dev/null: nothing there to keep or to replace.
bool is_stream(const fs::file_status& status) {
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_all(std::FILE* file, std::string_view text, const std::string& path) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return;
  if (!written) errno = error;
  throw InputError(path + ": cannot be written: " + reason());
}

}  // namespace

void require_writable(const std::string& path, IfExists if_exists) {
  if (path.empty()) throw InputError("the name of the output file is empty");
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status) || path.back() == '/')
    throw InputError(path + ": is a directory, a file to write is expected");
  if (is_stream(status)) return;
  if (if_exists == IfExists::refuse && fs::exists(fs::symlink_status(path, ignored)))
    throw InputError(path + ": exists already; --force replaces it");
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, ignored))
    throw InputError(path + ": cannot be written: there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(path + ": cannot be written: " + folder.string() + ": " + reason());
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0)
    throw InputError(path + ": cannot be replaced: " + reason());
}

void write_text(const std::string& path, std::string_view text, IfExists if_exists) {
  require_writable(path, if_exists);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (is_stream(status)) {
    std::FILE* const stream = std::fopen(path.c_str(), "wb");
    if (!stream) throw InputError(path + ": cannot be written: " + reason());
    write_all(stream, text, path);
    return;
  }
  // A link stays one: its target is what is written.
  fs::path target = path;
  if (fs::exists(status)) target = fs::canonical(path, error);
  if (error) target = path;
  const fs::path part = folder_of(target) / ("." + target.filename().string() + "." +
                                             std::to_string(::getpid()) + ".part");
  std::FILE* const file = std::fopen(part.c_str(), "wbx");
  if (!file) throw InputError(path + ": cannot be written: " + reason());
  try {
    write_all(file, text, path);
    if (fs::exists(status)) fs::permissions(part, status.permissions(), error);
    fs::rename(part, target, error);
    if (error) throw InputError(path + ": cannot be written: " + error.message());
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
}

}  // namespace raceway::io
