#pragma once

#include <optional>
#include <span>

#include "correction/beyond.h"
#include "correction/characteristic.h"
#include "correction/lag.h"

namespace raceway::correction {

/// First-order lag whose gain K and time constant T depend on its input x, a power loss or a load.
///
///   T(x) du/dt = K(x) - u
///
/// Source:   [Brecher2021, eq. 6 to 9]. The paper prints only the step response from rest, K (1 -
///           exp(-t/T)). If this formula were used for a changing x, u would jump at each change.
///           The equation above has the same step response, and u is continuous.
/// Units:    displacement u [m], K [m], T [s], power or load x [W or N].
/// Domain:   T(x) must be positive. A power x must not be negative. With the published linear
///           function T(x), x must be below 214.7 W. A load x may be negative, unless K or T is a
///           power law.
/// Traps:    the published K(x) is a linear function with K(0) = 10.36 um, although no heat is
///           produced at x = 0. In this code, K(0) is 0, so a spindle at standstill returns to its
///           rest position with the time constant T(0).
struct DelayElement {
  Characteristic gain, time_constant;
  bool both_signs = false;  ///< true: the input may be negative

  /// Returns the range of valid inputs, including `lower` and excluding `upper`.
  [[nodiscard]] Interval domain() const;
  /// Returns the final displacement for a constant input [m]; 0 for an input of 0.
  [[nodiscard]] double target(double input) const { return input != 0.0 ? gain(input) : 0.0; }
};

/// Computes the displacement at every row [m]. The input is in the unit of its column. Between two
/// rows, the input is constant: Clock::settings_hold selects the value of the earlier or of the
/// later row. Every run begins with u = 0. After the first input outside DelayElement::domain(),
/// the result is NaN until the end of the run. `seen` is the range of the input in the data of the
/// fit. Outside this range, continued() extrapolates K and T.
void delay_response(const Clock& clock, std::span<const double> input, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen = {});

}  // namespace raceway::correction
