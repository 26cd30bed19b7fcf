#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "effects/formula.h"

namespace raceway::python {

namespace py = pybind11;

/// Effect whose torque a Python function computes. `function(columns, values)` returns the torque
/// of each row [N mm].
struct OwnEffect {
  effects::UserMadeEffect described;
  py::object function;

  /// Returns the effect as an entry of model::Model::effects.
  [[nodiscard]] effects::Effect effect() const;
};

/// Reads user-defined effects from tuples (id, title, parameters, function), with a tuple (name,
/// unit, value, lower, upper) for each parameter.
[[nodiscard]] std::vector<OwnEffect> own_effects(const py::list& given);

}  // namespace raceway::python
