#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "fit/problem.h"

namespace raceway::python {

namespace py = pybind11;

/// Progress of a long calculation. The worker thread writes the progress, and the waiting thread
/// reads the progress.
class Progress {
 public:
  void set(double share, std::string_view step) {
    const std::lock_guard lock(mutex_);
    share_ = share;
    step_ = step;
  }
  [[nodiscard]] std::pair<double, std::string> get() const {
    const std::lock_guard lock(mutex_);
    return {share_, step_};
  }

 private:
  mutable std::mutex mutex_;
  double share_ = 0.0;
  std::string step_;
};

struct Waiting {
  double time_limit = std::numeric_limits<double>::infinity();  ///< [s]
  /// Python function that is called with the finished share of the work (0 to 1) and the name of
  /// the current step, at most 20 times per second. If `progress` is None, no function is called.
  py::object progress = py::none();
};

/// Runs long work on a separate thread without the interpreter lock, so that other Python threads
/// continue. The calling thread checks for signals. On KeyboardInterrupt, the function sets
/// `cancelled`, so that the work ends early. It raises KeyboardInterrupt after the end of the work.
/// At the time limit, it sets `cancelled` and raises TimeoutError if the work then ends with an
/// error.
template <typename Work>
auto interruptible(std::atomic<bool>& cancelled, const Progress& progress, const Waiting& waiting,
                   const Work& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  bool out_of_time = false, raised = false;
  std::unique_ptr<py::error_already_set> error;
  auto task = std::async(std::launch::async, [&] { return work(); });
  for (bool ready = false; !ready;) {
    {
      const py::gil_scoped_release others;
      ready =
          task.wait_for(std::chrono::milliseconds(raised ? 1000 : 50)) == std::future_status::ready;
    }
    if (raised || ready) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!waiting.progress.is_none()) {
        const auto [share, step] = progress.get();
        waiting.progress(share, step);
      }
    } catch (py::error_already_set& e) {
      error = std::make_unique<py::error_already_set>(std::move(e));
      raised = true;
      cancelled = true;
    }
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (elapsed > waiting.time_limit) out_of_time = cancelled = true;
  }
  // If cancelled work ends with an error, the cancellation caused this error.
  if (error) {
    task.wait();
    throw std::move(*error);
  }
  try {
    return task.get();
  } catch (...) {
    if (!out_of_time) throw;
    PyErr_Format(PyExc_TimeoutError, "no answer within %s s; allow more time with time_limit_s",
                 py::str(py::float_(waiting.time_limit)).cast<std::string>().c_str());
    throw py::error_already_set();
  }
}

}  // namespace raceway::python
