#pragma once

#include <string>
#include <string_view>

/// Bars and colours for tables on a terminal.
namespace raceway::cli {

/// Returns a bar of '#' whose length is proportional to value/full, with at most `width`
/// characters. A positive value has at least one '#'. `mark` is a value on the same scale, such as
/// the noise, and is drawn as '|'. `second` is another value on this scale, for example the
/// tolerance, and is drawn as ':'. If `mark` and `second` fall on the same character, only ':' is
/// drawn. A `mark` or `second` is not drawn if it is not above 0, or if it is above `full`. The
/// text is empty if `full` is not positive and finite.
[[nodiscard]] std::string bar(double value, double full, std::size_t width, double mark = -1.0,
                              double second = -1.0);

/// Returns true if stdout is a terminal that shows colours, NO_COLOR is not set, and TERM is not
/// "dumb".
[[nodiscard]] bool colours();

enum class Colour { good, bad, strong };

/// Returns the text in a colour if stdout shows colours. Otherwise, the text is unchanged.
[[nodiscard]] std::string in_colour(std::string_view text, Colour colour);

}  // namespace raceway::cli
