#pragma once

namespace raceway::text {

/// Buffer size for write_12_digits().
inline constexpr int twelve_digits_room = 32;

/// Writes a number as printf("%.12g") does, to the byte; returns its end, without a NUL.
///
/// Accuracy: exact. From 1e-4 to 1e12 the digits come from one rounded product and a whole number,
/// if the product is so far from the midpoint of two of them that its rounding cannot matter. All
/// other numbers use std::to_chars, which takes five times as long.
[[nodiscard]] char* write_12_digits(char* out, double value);

}  // namespace raceway::text
