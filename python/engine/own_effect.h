#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "effects/formula.h"

namespace raceway::python {

namespace py = pybind11;

/// An effect with a Python function as its moment: id, title, numbers and `function(columns,
/// values)`, which returns torques [N mm] for columns of rows.
struct OwnEffect {
  effects::UserMadeEffect described;
  py::object function;

  /// Makes an effect of a model with these numbers.
  [[nodiscard]] effects::Effect effect() const;
};

/// Reads tuples (id, title, [(name, unit, value, lower, upper)], function).
[[nodiscard]] std::vector<OwnEffect> own_effects(const py::list& given);

}  // namespace raceway::python
