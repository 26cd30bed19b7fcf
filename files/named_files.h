#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raceway::files {

/// A file that a model names, with the contents that it had when the model was read.
struct NamedFile {
  std::string name;  ///< name in the model: absolute, or relative to the folder of the model
  std::string path;  ///< absolute path
  std::string text;  ///< content of the file
};

/// Reads the files that a model names, each file only once.
class NamedFiles {
 public:
  /// `model` is the path of the model. File names are relative to the folder of the model. `held`
  /// contains files whose contents are already known; these files are not read again.
  explicit NamedFiles(const std::string& model, std::vector<NamedFile> held = {});

  /// Returns the file with this name. Throws InputError like read_text().
  [[nodiscard]] const NamedFile& read(const std::string& name);
  /// Returns the name of a file for messages.
  [[nodiscard]] std::string shown(const std::string& name) const;
  /// Returns the files read so far.
  [[nodiscard]] const std::vector<NamedFile>& list() const { return read_; }

 private:
  std::filesystem::path folder_;
  std::vector<NamedFile> held_, read_;
};

/// Changes the file names in the text of a model file, so that they remain valid if the text is
/// saved at `path`. `files` contains the named files. The names become relative to the folder of
/// `path`, or absolute if `path` is empty. The rest of the text does not change.
[[nodiscard]] std::string with_names_from(std::string text, const std::vector<NamedFile>& files,
                                          const std::string& path);

}  // namespace raceway::files
