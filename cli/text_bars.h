#pragma once

#include <string>
#include <string_view>

/// Bars and colours for tables on a terminal.
namespace raceway::cli {

/// A bar of '#' whose length shows value / full, at most `width` characters; a positive value shows
/// at least one. A `mark` up to `full`, a noise floor or a threshold, is a '|' in or beyond the
/// bar. A `second` mark, the tolerance, is a ':' that covers it.
[[nodiscard]] std::string bar(double value, double full, std::size_t width, double mark = -1.0,
                              double second = -1.0);

/// True if stdout is a terminal with colours: NO_COLOR is not set, TERM is not dumb.
[[nodiscard]] bool colours();

enum class Colour { good, bad, strong };

/// The text in a colour, if stdout takes colours; otherwise the text.
[[nodiscard]] std::string in_colour(std::string_view text, Colour colour);

}  // namespace raceway::cli
