#pragma once

#include <string>
#include <string_view>

/// Bars and colours for tables on a terminal.
namespace raceway::cli {

/// Returns a bar of '#' whose length is proportional to value/full, with at most `width`
/// characters; empty if `full` is not positive and finite. A positive value has at least one '#'. A
/// `mark` up to `full`, such as the noise or a threshold, is a '|' in the bar or after its end. A
/// `second` mark, for the tolerance, is a ':' and replaces a '|' at the same place.
[[nodiscard]] std::string bar(double value, double full, std::size_t width, double mark = -1.0,
                              double second = -1.0);

/// Returns true if stdout is a terminal that shows colours, NO_COLOR is not set, and TERM is not
/// "dumb".
[[nodiscard]] bool colours();

enum class Colour { good, bad, strong };

/// Returns the text in a colour if stdout shows colours; otherwise the text unchanged.
[[nodiscard]] std::string in_colour(std::string_view text, Colour colour);

}  // namespace raceway::cli
