#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "io/correction_file.h"
#include "python/engine/heard.h"

namespace raceway::python {

namespace py = pybind11;

/// Corrections of one file as Python holds them. They never change: several threads may ask them.
class EngineCorrection {
 public:
  EngineCorrection(const std::string& source, const std::string& text);

  [[nodiscard]] const io::CorrectionFile& file() const { return file_; }
  [[nodiscard]] const Heard& heard() const { return heard_; }
  /// Of all displacements.
  [[nodiscard]] py::list parameters() const;
  /// Columns that a record needs.
  [[nodiscard]] py::list inputs() const;

 private:
  Heard heard_;
  io::CorrectionFile file_;
};

void bind_correction(py::module_& module);

}  // namespace raceway::python
