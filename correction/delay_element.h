#pragma once

#include <optional>
#include <span>

#include "correction/beyond.h"
#include "correction/characteristic.h"
#include "correction/lag.h"

namespace raceway::correction {

/// A delay element of which gain and time constant go with the input x that drives it: the power
/// loss, a load.
///
///   T(x) du/dt = K(x) - u
///
/// Source:   [Brecher2021, eq. 6 to 9]; there printed as K (1 - exp(-t/T)), the step response from
///           rest, which a changing x would make jump. The state form has the same step response
///           and goes on from where it is.
/// Units:    K [m], T [s], x in the unit of its column: W, N.
/// Domain:   T positive, and of a power x >= 0: 0 <= P < 214.7 W for the published lines. A load
/// may
///           have either sign; a power law has none below 0.
/// Traps:    the published K is a line with K(0) = 10.36 um although nothing heats at P = 0. The
///           paper is silent: here K(0) = 0, so that a standing spindle cools towards its rest,
///           with T(0).
struct DelayElement {
  Characteristic gain, time_constant;
  bool both_signs = false;  ///< the input may lie below 0

  /// Inputs that it takes, from `lower` on and below `upper`.
  [[nodiscard]] Interval domain() const;
  /// The displacement towards which an input drives it [m].
  [[nodiscard]] double target(double input) const { return input != 0.0 ? gain(input) : 0.0; }
};

/// Displacement at every row [m]; the input, in the unit of its column, holds as the settings of
/// the clock do. Runs begin from rest. NaN from the first input on that lies outside the domain, to
/// the end of its run. Beyond the inputs that were seen K and T are continued(); an input of 0
/// drives nothing, seen or not.
void delay_response(const Clock& clock, std::span<const double> input, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen = {});

}  // namespace raceway::correction
