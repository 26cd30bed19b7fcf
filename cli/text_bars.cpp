#include "cli/text_bars.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace raceway::cli {

std::string bar(double value, double full, std::size_t width, double mark, double second) {
  if (!(full > 0.0) || !std::isfinite(full)) return {};
  const auto place = [&](double v) {
    return static_cast<std::size_t>(
        std::lround(std::clamp(v / full, 0.0, 1.0) * static_cast<double>(width)));
  };
  std::string text;
  if (value > 0.0) text.assign(std::max<std::size_t>(1, place(value)), '#');
  const auto set = [&](double at, char sign) {
    if (!(at > 0.0 && at <= full)) return;
    const std::size_t i = std::max<std::size_t>(1, place(at)) - 1;
    if (text.size() <= i) text.resize(i + 1, ' ');
    text[i] = sign;
  };
  set(mark, '|');
  set(second, ':');
  return text;
}

bool colours() {
  const char* none = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && (none == nullptr || *none == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::string in_colour(std::string_view text, Colour colour) {
  if (!colours()) return std::string(text);
  const char* code = colour == Colour::good ? "32" : colour == Colour::bad ? "33" : "1";
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

}  // namespace raceway::cli
