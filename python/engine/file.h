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

/// Model file as a Python object. The object never changes, so several threads may use it at the
/// same time.
class EngineFile {
 public:
  virtual ~EngineFile() = default;

  /// Returns the notes and warnings from reading the file.
  [[nodiscard]] const Heard& heard() const { return heard_; }
  /// Returns the file as an input of a calculation.
  [[nodiscard]] virtual session::Source source() const = 0;
  [[nodiscard]] virtual session::Part part() const = 0;
  [[nodiscard]] virtual std::vector<std::string> defaults() const = 0;
  /// Returns all parameters that a fit can change.
  [[nodiscard]] virtual std::vector<record::Parameter> parameters() const = 0;
  /// Adds the effects whose torque a Python function computes. They are added after reading,
  /// because a model file cannot contain such effects.
  virtual void amend(files::ModelFile&) const {}

 protected:
  Heard heard_;
};

/// Name, path and text of each file to which a model refers, such as a friction table. Python
/// stores the texts.
using HeldFiles = std::vector<std::tuple<std::string, std::string, std::string>>;

[[nodiscard]] inline std::vector<files::NamedFile> named_files(const HeldFiles& held) {
  std::vector<files::NamedFile> files;
  for (const auto& [name, path, text] : held) files.push_back({name, path, text});
  return files;
}

}  // namespace raceway::python
