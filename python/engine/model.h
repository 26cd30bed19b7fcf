#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "model/band.h"
#include "model/parameters.h"
#include "python/engine/arrays.h"
#include "python/engine/file.h"
#include "python/engine/own_effect.h"

namespace raceway::python {

/// Model of a bearing, a shaft or a spindle. The model can contain effects whose torque a Python
/// function computes.
class EngineModel final : public EngineFile {
 public:
  EngineModel(const std::string& source, const std::string& text, const py::list& own,
              const HeldFiles& held);

  [[nodiscard]] const files::ModelFile& file() const { return file_; }
  [[nodiscard]] session::Source source() const override {
    return {file_.source, file_.text, file_.files};
  }
  [[nodiscard]] session::Part part() const override { return session::Part::bearing; }
  [[nodiscard]] std::vector<std::string> defaults() const override {
    return files::lines(file_.defaults);
  }
  [[nodiscard]] std::vector<record::Parameter> parameters() const override {
    return model::parameters(file_.model);
  }
  void amend(files::ModelFile& file) const override;
  /// Returns the confidence band of the model from the covariance of the fitted parameters. The
  /// result is empty if `wanted` is false. Throws text::InputError if the model file has no
  /// covariance.
  [[nodiscard]] std::optional<model::Band> band(bool wanted) const;
  /// Returns "rig", "shaft" or "spindle".
  [[nodiscard]] std::string kind() const;
  /// Returns the text of the model file with new parameter values. `values` contains the values by
  /// parameter name.
  [[nodiscard]] std::string with_values(const py::dict& values) const;

 private:
  std::vector<OwnEffect> own_;
  files::ModelFile file_;
};

void bind_model(py::module_& module);
void bind_tables(py::module_& module);
void bind_loop(py::module_& module);
void bind_spindle(py::module_& module);
void bind_sensitivity(py::module_& module);

}  // namespace raceway::python
