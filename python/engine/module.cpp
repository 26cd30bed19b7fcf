#include <pybind11/pybind11.h>
#include <tbb/global_control.h>

#include <cstddef>
#include <memory>
#include <string>

#include "bearing/solve_many.h"
#include "fit/problem.h"
#include "python/engine/answer.h"
#include "python/engine/correction.h"
#include "python/engine/model.h"
#include "text/error.h"

/// What the library answers, as plain Python objects; the package raceway around it is what people
/// use. Long work runs without the lock of the interpreter.
namespace raceway::python {
namespace {

/// text::InputError is raceway.InputError, a ValueError with file, line and key.
void raise_input_error(const py::object& type, const text::InputError& e) {
  const py::object error = type(py::module_::import("raceway._errors").attr("in_python")(e.what()));
  error.attr("file") = e.place.file.empty() ? py::none() : py::object(py::str(e.place.file));
  error.attr("line") = e.place.line > 0 ? py::object(py::int_(e.place.line)) : py::none();
  error.attr("key") = e.place.key.empty() ? py::none() : py::object(py::str(e.place.key));
  PyErr_SetObject(type.ptr(), error.ptr());
}

/// Threads that work at once in this process from now on; 0: as many as it has cores.
void limit_threads(std::size_t threads) {
  // Never destroyed: at exit TBB may be gone before it.
  static auto& limit = *new std::unique_ptr<tbb::global_control>;
  limit.reset();
  if (threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  threads);
}

}  // namespace
}  // namespace raceway::python

PYBIND11_MODULE(_engine, module) {
  using namespace raceway::python;
  module.doc() = "The engine of raceway; use the package raceway.";
  module.attr("__version__") = RACEWAY_VERSION;
  module.def("limit_threads", &limit_threads);
  module.def("instruction_set", [] {
    return std::string(raceway::bearing::name(raceway::bearing::best_instruction_set()));
  });
  static const py::object* const input_error =
      new py::object(py::module_::import("raceway._errors").attr("InputError"));
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const raceway::text::InputError& e) {
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
