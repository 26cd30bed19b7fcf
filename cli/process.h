#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

/// Controls the standard streams, the stop signals and the time limit of the process.
namespace raceway::cli {

/// Prepares the standard streams and the stop signals of the process. Call start_process() before
/// all other functions. If stdout or stderr is closed at the start, output to this stream fails
/// after this call. Without this call, output to a closed stream would go into the file that the
/// program opens next. On a stop signal (Ctrl-C, kill, a closed terminal) that is not ignored, the
/// process removes unfinished files, lists the complete files on stderr, and ends with this signal.
/// If a file reaches the size limit of the process, the program reports an error as for a full
/// disk.
void start_process();

/// Sets the flag raised() at the first Ctrl-C, or when `seconds` [s] have passed. While an
/// InterruptFlag exists, the first Ctrl-C does not end the process.
class InterruptFlag {
 public:
  explicit InterruptFlag(double seconds);
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;
  [[nodiscard]] static const std::atomic<bool>& raised();
  [[nodiscard]] bool out_of_time() const { return out_of_time_; }

 private:
  struct Clock;
  std::atomic<bool> out_of_time_{false};
  std::unique_ptr<Clock> clock_;
};

/// Writes to stderr, without terminal control characters. A failed write is ignored.
void write_message(std::string_view text);

/// Flushes stdout at the end of a run, to detect a full disk or a closed pipe. Returns the error
/// message, or an empty text without an error.
[[nodiscard]] std::string stdout_problem();

/// Returns the message of stdout_problem() for an error number of the system (errno).
[[nodiscard]] std::string stdout_problem(int error);

}  // namespace raceway::cli
