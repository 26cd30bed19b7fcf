#include "text/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <mutex>
#include <set>

#include "text/error.h"
#include "text/names.h"

namespace raceway::text {
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

InputError cannot_write(const std::string& path) {
  return InputError(path + ": cannot be written: " + reason(), {.file = path});
}

void write_all(std::FILE* file, std::string_view text, const std::string& path) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return;
  if (!written) errno = error;
  throw cannot_write(path);
}

/// What this process has under way. Never destroyed: it may be told to stop while it ends.
struct Writing {
  std::mutex mutex;
  std::set<fs::path> parts;
  std::vector<std::string> written;
};

Writing& writing() {
  static auto* const one = new Writing;
  return *one;
}

/// A file that is not whole yet, beside the one whose name it takes; removed unless it did. A name
/// that a killed process has left is passed over.
class Part {
 public:
  explicit Part(const fs::path& folder) {
    const std::lock_guard lock(writing().mutex);
    for (int k = 0; !file_; ++k) {
      path_ =
          folder / (".raceway-" + std::to_string(::getpid()) + "-" + std::to_string(k) + ".part");
      file_ = std::fopen(path_.c_str(), "wbx");
      if (!file_ && errno != EEXIST) return;
    }
    writing().parts.insert(path_);
  }
  ~Part() {
    if (!file_) return;
    const std::lock_guard lock(writing().mutex);
    if (writing().parts.erase(path_) > 0) ::unlink(path_.c_str());
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  [[nodiscard]] std::FILE* file() const { return file_; }
  [[nodiscard]] const fs::path& path() const { return path_; }

  /// Gives the file its name; false, with errno, where that fails. `told`: the name for users.
  bool take_name(const fs::path& target, IfExists if_exists, const std::string& told) {
    const std::lock_guard lock(writing().mutex);
    if (!(if_exists == IfExists::replace ? ::rename(path_.c_str(), target.c_str()) == 0
                                         : take_free_name(target)))
      return false;
    writing().parts.erase(path_);
    writing().written.push_back(told);
    return true;
  }

 private:
  /// In one step, so that of two who write the same file neither loses it unawares.
  [[nodiscard]] bool take_free_name(const fs::path& target) const {
    if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0)
      return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    // A file system that cannot, such as NFS.
    if (::link(path_.c_str(), target.c_str()) != 0) return false;
    ::unlink(path_.c_str());
    return true;
  }

  fs::path path_;
  std::FILE* file_ = nullptr;
};

std::string exists_already(const std::string& path, IfExists if_exists) {
  const bool force = if_exists == IfExists::refuse;
  return path + ": exists already; " + (force ? "--force" : "--replace") + " replaces it";
}

/// All of a file, beside the place that it takes.
class WholeFile {
 public:
  WholeFile(const std::string& path, std::string_view text)
      : path_(path), target_(target_of(path)), part_(folder_of(target_)) {
    if (!part_.file()) throw cannot_write(path);
    write_all(part_.file(), text, path);
    std::error_code ignored;
    if (const fs::file_status old = fs::status(path, ignored); fs::exists(old))
      fs::permissions(part_.path(), old.permissions(), ignored);
  }

  [[nodiscard]] fs::path folder() const { return folder_of(target_); }

  void take_name(IfExists if_exists) {
    if (part_.take_name(target_, if_exists, path_)) return;
    if (errno == EEXIST)
      throw InputError(
          exists_already(path_, if_exists) + " (another program created it during this run)",
          {.file = path_});
    throw cannot_write(path_);
  }

 private:
  /// A link stays one: its target is what is written.
  static fs::path target_of(const std::string& path) {
    std::error_code error;
    if (!fs::exists(fs::status(path, error))) return path;
    fs::path target = fs::canonical(path, error);
    return error ? fs::path(path) : target;
  }

  std::string path_;
  fs::path target_;
  Part part_;
};

/// Files of one folder take their names without those of another run in between. Nothing for an
/// empty path, and on file systems that cannot lock.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : file_(folder.empty() ? -1 : ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ >= 0) (void)::flock(file_, LOCK_EX);
  }
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

/// All that is written is text. A file whose name promises more would not open.
void refuse_other_formats(const std::string& path) {
  struct Format {
    std::string_view endings, kind, instead;
  };
  constexpr std::array formats{
      Format{" .xlsx .xls .xlsm .xlsb .ods ", "a workbook",
             "tables are written as CSV, which Excel can open: use a name that ends with .csv"},
      Format{
          " .png .jpg .jpeg .gif .bmp .tif .tiff .webp .pdf .eps .ps ", "a picture or a page",
          "pictures are written as SVG and pages as HTML: use a name that ends with .svg or .html"},
      Format{" .mat .npy .npz .h5 .hdf5 .parquet .feather .pkl .zip .gz ", "a binary file",
             "files are written as text: use a name that ends with .csv, .json or .toml"}};
  const std::string ending = lower_case(fs::path(path).extension().string());
  if (ending.empty()) return;
  for (const Format& format : formats)
    if (format.endings.find(" " + ending + " ") != std::string_view::npos)
      throw InputError(
          fmt::format("{}: this is the name of {}, but {}", path, format.kind, format.instead),
          {.file = path});
}

}  // namespace

void require_name_of(const std::string& path, Written what) {
  struct Format {
    std::string_view endings, words, name;
  };
  // In the order of Written.
  constexpr std::array formats{Format{".csv", "tables are written as CSV", ".csv"},
                               Format{".svg", "pictures are written as SVG", ".svg"},
                               Format{".html .htm", "pages are written as HTML", ".html"}};
  constexpr std::string_view ours = " .csv .svg .html .htm .json .toml .py .c ";
  const std::string ending = lower_case(fs::path(path).extension().string());
  if (ending.empty() || ours.find(" " + ending + " ") == ours.npos) return;
  const Format& format = formats[static_cast<std::size_t>(what)];
  if (format.endings.find(ending) == format.endings.npos)
    throw InputError(
        fmt::format("{}: {}; use a name that ends with {}", path, format.words, format.name),
        {.file = path});
}

void require_writable(const std::string& path, IfExists if_exists) {
  refuse_other_formats(path);
  if (path.empty()) throw InputError("the name of the output file is empty");
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status) || path.back() == '/')
    throw InputError(path + ": is a directory; name a file", {.file = path});
  if (is_stream(status)) return;
  if (if_exists != IfExists::replace && fs::exists(fs::symlink_status(path, ignored)))
    throw InputError(exists_already(path, if_exists), {.file = path});
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, ignored))
    throw InputError(path + ": cannot be written: this folder does not exist: " + folder.string(),
                     {.file = path});
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(path + ": cannot be written: " + folder.string() + ": " + reason(),
                     {.file = path});
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0)
    throw InputError(path + ": cannot be replaced: " + reason(), {.file = path});
}

void write_text(const std::string& path, std::string_view text, IfExists if_exists) {
  write_files({{path, text}}, if_exists);
}

void write_files(const std::vector<OutputFile>& files, IfExists if_exists) {
  for (const OutputFile& file : files) require_writable(file.path, if_exists);
  std::deque<WholeFile> whole;
  for (const OutputFile& file : files) {
    std::error_code error;
    if (!is_stream(fs::status(file.path, error))) {
      whole.emplace_back(file.path, file.text);
      continue;
    }
    std::FILE* const stream = std::fopen(file.path.c_str(), "wb");
    if (!stream) throw cannot_write(file.path);
    write_all(stream, file.text, file.path);
  }
  const FolderLock lock(files.size() > 1 && !whole.empty() ? whole.front().folder() : fs::path());
  if (if_exists != IfExists::replace && whole.size() > 1)
    for (const OutputFile& file : files) require_writable(file.path, if_exists);
  for (WholeFile& file : whole) file.take_name(if_exists);
}

std::vector<std::string> stop_writing() {
  Writing& all = writing();
  all.mutex.lock();  // for good
  for (const fs::path& part : all.parts) ::unlink(part.c_str());
  return all.written;
}

}  // namespace raceway::text
