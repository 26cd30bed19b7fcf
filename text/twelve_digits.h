#pragma once

namespace raceway::text {

/// Room that write_12_digits() may need.
inline constexpr int twelve_digits_room = 32;

/// Writes a number as printf("%.12g") does, to the byte; returns its end, without a NUL.
///
/// Accuracy: exact. From 1e-4 to 1e12 the digits come from one rounded product and a whole number,
/// where the product lies so far from the middle between two of them that its rounding cannot
/// matter; anything else goes to std::to_chars, which takes five times as long.
[[nodiscard]] char* write_12_digits(char* out, double value);

}  // namespace raceway::text
