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
/// Source:   [Brecher2021, eq. 6 to 9]. The paper prints K (1 - exp(-t/T)), the step response from
///           rest. With that formula, u would jump when x changes. The equation above has the same
///           step response, and u is continuous.
/// Units:    displacement u [m], K [m], T [s], power or load x [W or N].
/// Domain:   T is positive. If x is a power, it must not be negative, and with the published
///           lines it must be below 214.7 W. If x is a load, it may be negative, unless K or T is
///           a power law.
/// Traps:    the published K is a line with K(0) = 10.36 um, although no heat is produced at x = 0.
///           Here K(0) = 0, so a spindle at standstill returns to its rest position with the time
///           constant T(0).
struct DelayElement {
  Characteristic gain, time_constant;
  bool both_signs = false;  ///< true: the input may be negative

  /// Returns the range of valid inputs, including `lower` and excluding `upper`.
  [[nodiscard]] Interval domain() const;
  /// Returns the final displacement for a constant input [m]; 0 for an input of 0.
  [[nodiscard]] double target(double input) const { return input != 0.0 ? gain(input) : 0.0; }
};

/// Computes the displacement at every row [m]. The input is in the unit of its column. Between
/// rows, the input is constant: Clock::settings_hold selects the earlier or the later of the two
/// rows. Every run begins with u = 0. After the first input outside DelayElement::domain(), the
/// result is NaN until the end of the run. Beyond the range `seen` of the fit, continued()
/// extrapolates K and T.
void delay_response(const Clock& clock, std::span<const double> input, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen = {});

}  // namespace raceway::correction
