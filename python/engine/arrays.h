#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "record/digits.h"
#include "session/solve_states.h"
#include "text/error.h"

namespace raceway::python {

namespace py = pybind11;

/// Reference to an array of doubles in Python, with any shape and strides.
using Doubles = py::array_t<double>;

/// Rounds an input value, such as a speed, to 13 digits. The result equals the number that the user
/// entered, although the conversion to SI and back can change the last digit of a double. Without
/// rounding, a filter such as frame.speed_rpm == 1500 would find no rows.
inline double as_entered(double value) { return record::with_digits(value, 13); }

/// Returns the common shape of arrays by the broadcasting rules of NumPy. Throws text::InputError
/// if there is no common shape.
inline std::vector<std::size_t> broadcast_shape(
    const std::vector<std::pair<std::string, Doubles>>& arrays) {
  std::size_t dimensions = 0;
  for (const auto& [name, array] : arrays)
    dimensions = std::max(dimensions, static_cast<std::size_t>(array.ndim()));
  std::vector<std::size_t> shape(dimensions, 1);
  for (const auto& [name, array] : arrays) {
    const auto own = static_cast<std::size_t>(array.ndim());
    for (std::size_t d = 0; d < own; ++d) {
      std::size_t& common = shape[dimensions - own + d];
      const auto length = static_cast<std::size_t>(array.shape(static_cast<py::ssize_t>(d)));
      if (length == common || length == 1) continue;
      if (common != 1) {
        std::string shapes;
        for (const auto& [other, of_other] : arrays)
          shapes += (shapes.empty() ? "" : ", ") + other + " " +
                    py::str(of_other.attr("shape")).cast<std::string>();
        throw text::InputError("arrays of different shapes cannot be used together: " + shapes +
                               "; use single values or arrays of the same shape");
      }
      common = length;
    }
  }
  return shape;
}

/// Returns a view of an array in the shape `shape`. The numbers are not copied. Along each
/// dimension that the array lacks, or in which its length is 1, the view repeats the numbers.
inline session::NumberArray number_array(const Doubles& array,
                                         const std::vector<std::size_t>& shape) {
  session::NumberArray numbers;
  numbers.data = reinterpret_cast<const char*>(array.data());
  numbers.strides.assign(shape.size(), 0);
  const auto own = static_cast<std::size_t>(array.ndim());
  for (std::size_t d = 0; d < own; ++d) {
    const auto at = static_cast<py::ssize_t>(d);
    if (array.shape(at) != 1) numbers.strides[shape.size() - own + d] = array.strides(at);
  }
  return numbers;
}

/// Moves a vector into an array of the shape `shape`. The numbers are not copied.
template <typename Number>
py::array_t<Number> owned(std::vector<Number> values, const std::vector<std::size_t>& shape) {
  auto* const kept = new std::vector<Number>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Number>*>(p); });
  return py::array_t<Number>(std::vector<py::ssize_t>(shape.begin(), shape.end()), kept->data(),
                             owner);
}

}  // namespace raceway::python
