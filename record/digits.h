#pragma once

namespace raceway::record {

/// Returns `value` rounded to `digits` significant decimal digits. `digits` is 1 to 17.
///
/// Fifteen digits remove the rounding error of a unit conversion: 6000.000000000001 rpm becomes
/// 6000 rpm. The result does not depend on the locale. NaN, infinite values and values that would
/// round to infinity are returned unchanged.
[[nodiscard]] double with_digits(double value, int digits);

}  // namespace raceway::record
