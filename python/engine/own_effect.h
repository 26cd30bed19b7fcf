#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "effects/formula.h"

namespace raceway::python {

namespace py = pybind11;

/// An effect whose torque a Python function computes: id, title, parameters and function.
/// `function(columns, values)` returns the torque of each row [N mm].
struct OwnEffect {
  effects::UserMadeEffect described;
  py::object function;

  /// Returns the effect for a model, with its parameters.
  [[nodiscard]] effects::Effect effect() const;
};

/// Reads tuples (id, title, [(name, unit, value, lower, upper)], function).
[[nodiscard]] std::vector<OwnEffect> own_effects(const py::list& given);

}  // namespace raceway::python
