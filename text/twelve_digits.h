#pragma once

namespace raceway::text {

/// Buffer size for write_12_digits().
inline constexpr int twelve_digits_room = 32;

/// Writes exactly the characters of printf("%.12g") for a number, without a final NUL. Returns the
/// end of the text.
///
/// Accuracy: exact. A number with a magnitude outside 1e-4 to 1e12 takes about five times as long
///           as a number inside this range.
[[nodiscard]] char* write_12_digits(char* out, double value);

}  // namespace raceway::text
