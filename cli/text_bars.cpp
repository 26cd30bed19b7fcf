#include "cli/text_bars.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace raceway::cli {

std::string bar(double value, double full, std::size_t width, double mark) {
  if (!(full > 0.0) || !std::isfinite(full)) return {};
  const auto place = [&](double v) {
    return static_cast<std::size_t>(
        std::lround(std::clamp(v / full, 0.0, 1.0) * static_cast<double>(width)));
  };
  std::string text;
  if (value > 0.0) text.assign(std::max<std::size_t>(1, place(value)), '#');
  if (mark > 0.0 && mark <= full) {
    const std::size_t at = std::max<std::size_t>(1, place(mark)) - 1;
    if (text.size() <= at) text.resize(at + 1, ' ');
    text[at] = '|';
  }
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
