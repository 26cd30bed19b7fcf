#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raceway::files {

/// A file named by a model, as it was when the model was opened.
struct NamedFile {
  std::string name;  ///< name in the model: relative to the folder of the model, or absolute
  std::string path;  ///< absolute path
  std::string text;  ///< content of the file
};

/// Files named by a model. Each file is read once.
class NamedFiles {
 public:
  /// `model` is the path of the model. Names are relative to the folder of the model. Files in
  /// `held` are not read again.
  explicit NamedFiles(const std::string& model, std::vector<NamedFile> held = {});

  /// Returns the file with this name. Throws InputError like read_text().
  [[nodiscard]] const NamedFile& read(const std::string& name);
  /// Returns the file name for messages.
  [[nodiscard]] std::string shown(const std::string& name) const;
  /// Returns the files read so far.
  [[nodiscard]] const std::vector<NamedFile>& list() const { return read_; }

 private:
  std::filesystem::path folder_;
  std::vector<NamedFile> held_, read_;
};

/// Returns the text of a model for saving in a file at `path`. File names in the text become
/// relative to the folder of `path`, or absolute if `path` is empty. Nothing else changes.
[[nodiscard]] std::string with_names_from(std::string text, const std::vector<NamedFile>& files,
                                          const std::string& path);

}  // namespace raceway::files
