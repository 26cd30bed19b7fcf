#include "cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace raceway::cli {
namespace {

std::string time_left(double share, double elapsed) {
  constexpr double least_share = 0.02, least_time = 0.5;  // before, nothing can be said
  if (share < least_share || elapsed < least_time || share >= 1.0) return {};
  const double left = elapsed * (1.0 - share) / share;
  if (left < 90.0) return fmt::format("{:.0f} s left", std::ceil(left));
  if (left < 5400.0) return fmt::format("{:.0f} min left", std::ceil(left / 60.0));
  return fmt::format("{:.1f} h left", left / 3600.0);
}

std::size_t width_of_stderr() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void put(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string progress_line(double share, double elapsed, std::string_view step, std::size_t width) {
  constexpr std::size_t beside = 24, narrow = 10, wide = 40;  // characters; of the bar the last two
  const std::size_t bar = std::clamp(width > beside ? width - beside : 0, narrow, wide);
  // 100 % is said when it is so.
  const double shown = share < 1.0 ? std::clamp(share, 0.0, 0.99) : 1.0;
  const auto filled = static_cast<std::size_t>(shown * static_cast<double>(bar));
  std::string line = fmt::format("[{}{}] {:3.0f} %", std::string(filled, '#'),
                                 std::string(bar - filled, '.'), std::floor(100.0 * shown));
  const std::string left = time_left(share, elapsed);
  for (const std::string_view more : {std::string_view(left), step})
    if (!more.empty()) line += fmt::format("  {}", more);
  if (line.size() > width) line.resize(width);
  return line;
}

Progress::Progress() : start_(Clock::now()), shown_(start_ - std::chrono::hours(1)) {}

Progress::~Progress() { put("\r\033[K"); }

void Progress::show(double share, std::string_view step) {
  const Clock::time_point now = Clock::now();
  if (share < 1.0 && now - shown_ < std::chrono::milliseconds(100)) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  put("\r\033[K" + progress_line(share, elapsed, step, width_of_stderr() - 1));
}

}  // namespace raceway::cli
