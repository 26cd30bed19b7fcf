#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "files/model_file.h"
#include "files/named_files.h"
#include "python/engine/heard.h"
#include "session/loop_model.h"
#include "session/source.h"

namespace raceway::python {

/// A model file as Python holds it. It never changes: several threads may ask it at once.
class EngineFile {
 public:
  virtual ~EngineFile() = default;

  /// Notes of the opening.
  [[nodiscard]] const Heard& heard() const { return heard_; }
  /// The file, for a question.
  [[nodiscard]] virtual session::Source source() const = 0;
  [[nodiscard]] virtual session::Part part() const = 0;
  [[nodiscard]] virtual std::vector<std::string> defaults() const = 0;
  /// Puts into a model what no file can say.
  virtual void amend(files::ModelFile&) const {}

 protected:
  Heard heard_;
};

/// Files that a model names, as Python keeps them: name, path and text of each.
using HeldFiles = std::vector<std::tuple<std::string, std::string, std::string>>;

[[nodiscard]] inline std::vector<files::NamedFile> named_files(const HeldFiles& held) {
  std::vector<files::NamedFile> files;
  for (const auto& [name, path, text] : held) files.push_back({name, path, text});
  return files;
}

}  // namespace raceway::python
