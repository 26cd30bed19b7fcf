#pragma once

namespace raceway::text {

/// Buffer size for write_12_digits().
inline constexpr int twelve_digits_room = 32;

/// Writes exactly the characters of printf("%.12g") for a number, without a final NUL. Returns the
/// end of the text.
///
/// Accuracy: exact. From 1e-4 to 1e12 the digits come from the product of the value and a power of
/// ten, rounded to a whole number. The function uses the product only if the product is so far from
/// the midpoint of two whole numbers that its rounding error has no effect. All other numbers use
/// std::to_chars, which takes five times as long.
[[nodiscard]] char* write_12_digits(char* out, double value);

}  // namespace raceway::text
