#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "files/correction_file.h"
#include "python/engine/file.h"

namespace raceway::python {

namespace py = pybind11;

/// File with corrections of one or more displacements.
class EngineCorrection final : public EngineFile {
 public:
  EngineCorrection(const std::string& source, const std::string& text, const HeldFiles& held);

  [[nodiscard]] const files::CorrectionFile& file() const { return file_; }
  [[nodiscard]] session::Source source() const override {
    return {file_.source, file_.text, file_.files};
  }
  [[nodiscard]] session::Part part() const override { return session::Part::correction; }
  [[nodiscard]] std::vector<std::string> defaults() const override {
    return files::lines(file_.defaults);
  }
  /// Returns the parameters of all corrections. If there are several displacements, the name of
  /// each parameter begins with the name of its displacement.
  [[nodiscard]] std::vector<record::Parameter> parameters() const override;
  /// Returns the columns that a record needs for these corrections.
  [[nodiscard]] py::list inputs() const;
  /// Returns the level of trust in each correction, such as "good". The keys of the dictionary are
  /// the column names of the displacements.
  [[nodiscard]] py::dict trust() const;

 private:
  files::CorrectionFile file_;
};

void bind_correction(py::module_& module);

}  // namespace raceway::python
