#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <thread>

/// What the program as a process has to do with the one that started it.
namespace raceway::cli {

/// Before anything else: standard streams that are closed fail from now on, where the next file to
/// be opened would have taken their place; told to stop (Ctrl-C, kill, a closed terminal), the
/// process removes what is half written, says on stderr what was kept, and ends by that signal; a
/// limit of file size is an error as a full disk is.
void start_process();

/// While it lives, the first Ctrl-C raises a flag in place of ending the process, and so does the
/// end of `seconds`.
class InterruptFlag {
 public:
  explicit InterruptFlag(double seconds);
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;
  [[nodiscard]] static const std::atomic<bool>& raised();
  [[nodiscard]] bool out_of_time() const { return out_of_time_; }

 private:
  std::atomic<bool> out_of_time_{false};
  std::jthread clock_;
};

/// Onto stderr, without what a terminal would obey. One that cannot be written keeps nothing from
/// being done.
void write_message(std::string_view text);

/// Sends off what stdout still holds: a full disk or a closed pipe shows at the end. Empty, or what
/// is wrong.
[[nodiscard]] std::string stdout_problem();

/// The same in the words for an error that is known already.
[[nodiscard]] std::string stdout_problem(int error);

}  // namespace raceway::cli
