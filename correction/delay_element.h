#pragma once

#include <optional>
#include <span>

#include "correction/beyond.h"
#include "correction/characteristic.h"
#include "correction/lag.h"

namespace raceway::correction {

/// Delay element whose gain and time constant depend on its input x. The input is the power loss or
/// a load.
///
///   T(x) du/dt = K(x) - u
///
/// Source:   [Brecher2021, eq. 6 to 9]. The paper prints K (1 - exp(-t/T)), the step response from
///           rest. That form would jump when x changes. This file uses the state form, which has
///           the same step response and continues from the current state.
/// Units:    displacement u [m], K [m], T [s], x in the unit of its column: W, N.
/// Domain:   T is positive. A power must be x >= 0; the published lines need 0 <= P < 214.7 W. A
///           load may have either sign, except with a power law, which is not defined below 0.
/// Traps:    the published K is a line with K(0) = 10.36 um, although no heat is produced at P = 0.
///           The paper does not discuss this displacement without heat. Here K(0) = 0, so a spindle
///           at standstill cools towards its rest position with the time constant T(0).
struct DelayElement {
  Characteristic gain, time_constant;
  bool both_signs = false;  ///< true: the input may be negative

  /// Returns the range of accepted inputs, including `lower` and excluding `upper`.
  [[nodiscard]] Interval domain() const;
  /// Returns the final displacement for a constant input [m].
  [[nodiscard]] double target(double input) const { return input != 0.0 ? gain(input) : 0.0; }
};

/// Computes the displacement at every row [m]. The input is in the unit of its column. Between
/// rows, the input is constant; Clock::settings_hold selects the row with its value. Every run
/// begins at rest. After the first input outside the domain, the result is NaN until the end of the
/// run. Beyond the range of the fit, continued() extrapolates K and T. An input of 0 always gives
/// the target 0.
void delay_response(const Clock& clock, std::span<const double> input, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen = {});

}  // namespace raceway::correction
