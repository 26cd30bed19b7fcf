#include <pybind11/pybind11.h>

#include <string>

#include "fit/problem.h"
#include "io/error.h"
#include "python/engine/answer.h"
#include "python/engine/correction.h"
#include "python/engine/model.h"

/// What the library answers, as plain Python objects; the package raceway around it is what people
/// use. Long work runs without the lock of the interpreter.
namespace raceway::python {
namespace {

/// io::InputError is raceway.InputError, a ValueError with file, line and key.
void raise_input_error(const py::object& type, const io::InputError& e) {
  const py::object error = type(py::module_::import("raceway._errors").attr("in_python")(e.what()));
  error.attr("file") = e.place.file.empty() ? py::none() : py::object(py::str(e.place.file));
  error.attr("line") = e.place.line > 0 ? py::object(py::int_(e.place.line)) : py::none();
  error.attr("key") = e.place.key.empty() ? py::none() : py::object(py::str(e.place.key));
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace
}  // namespace raceway::python

PYBIND11_MODULE(_engine, module) {
  using namespace raceway::python;
  module.doc() = "The engine of raceway; use the package raceway.";
  module.attr("__version__") = RACEWAY_VERSION;
  static const py::object* const input_error =
      new py::object(py::module_::import("raceway._errors").attr("InputError"));
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const raceway::io::InputError& e) {
      raise_input_error(*input_error, e);
    } catch (const raceway::fit::Cancelled&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  bind_model(module);
  bind_tables(module);
  bind_answer(module);
  bind_loop(module);
  bind_correction(module);
  bind_spindle(module);
  bind_sensitivity(module);
}
