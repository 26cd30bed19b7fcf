#include "cli/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <glog/logging.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "text/names.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

std::atomic<bool> flag_is_up{false};   ///< by Ctrl-C
std::atomic<bool> flag_counts{false};  ///< else Ctrl-C ends the process

void close_gaps() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // Opened the wrong way round, so that using it fails.
    if (fcntl(stream, F_GETFD) == -1)
      static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

/// Those that were not ignored, as nohup does.
sigset_t signals_to_stop() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&set, number);
  }
  return set;
}

[[noreturn]] void stop(int number, const sigset_t& set) {
  const std::vector<std::string> written = text::stop_writing();
  write_message(fmt::format("{}raceway: stopped; {}\n", isatty(STDERR_FILENO) != 0 ? "\n" : "",
                            written.empty()
                                ? "no file was written or changed"
                                : "these files are complete: " + text::listed(written)));
  std::signal(number, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  std::raise(number);
  std::_Exit(128 + number);
}

/// A thread waits for the signals, so that what follows is no handler's business. All others are
/// started later and inherit that they do not take them.
void stop_in_order() {
  const sigset_t set = signals_to_stop();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  try {
    std::thread([set] {
      for (int number = 0; sigwait(&set, &number) == 0;) {
        if (number != SIGINT || !flag_counts.exchange(false)) stop(number, set);
        flag_is_up = true;
      }
    }).detach();
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
}

}  // namespace

void start_process() {
  close_gaps();
  std::signal(SIGXFSZ, SIG_IGN);
  // Ceres logs trial points without balance as errors; statuses and messages say it where it
  // counts.
  FLAGS_minloglevel = google::GLOG_FATAL;
  stop_in_order();
}

struct InterruptFlag::Clock {
  std::jthread thread;
};

InterruptFlag::InterruptFlag(double seconds) : clock_(std::make_unique<Clock>()) {
  flag_is_up = false;
  flag_counts = true;
  clock_->thread = std::jthread([this, seconds](const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any waiting;
    waiting.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
    if (stop.stop_requested()) return;
    out_of_time_ = true;
    flag_is_up = true;
  });
}

InterruptFlag::~InterruptFlag() { flag_counts = false; }

const std::atomic<bool>& InterruptFlag::raised() { return flag_is_up; }

}  // namespace raceway::cli
