#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

/// Process control: standard streams, signals, time limit.
namespace raceway::cli {

/// Prepares the process; call it first. A closed standard stream then fails, instead of being
/// replaced by the next file that is opened. On a stop signal (Ctrl-C, kill, a closed terminal) the
/// process removes half-written files, lists the kept ones on stderr, and ends by that signal. A
/// file size limit is an error like a full disk.
void start_process();

/// Raises a flag at the first Ctrl-C, instead of ending the process, and after `seconds`, during
/// its lifetime.
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

/// Flushes stdout, so that a full disk or a closed pipe shows at the end. Returns the error, or an
/// empty text.
[[nodiscard]] std::string stdout_problem();

/// Returns the same message for a known error number.
[[nodiscard]] std::string stdout_problem(int error);

}  // namespace raceway::cli
