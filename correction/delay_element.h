#pragma once

#include <optional>
#include <span>

#include "correction/beyond.h"
#include "correction/characteristic.h"
#include "correction/lag.h"

namespace raceway::correction {

/// A delay element of which gain and time constant go with the power loss P that drives it.
///
///   T(P) du/dt = K(P) - u
///
/// Source:   [Brecher2021, eq. 7 to 9]; there printed as K (1 - exp(-t/T)), the step response from
///           rest, which a changing P would make jump. The state form has the same step response
///           and goes on from where it is.
/// Units:    K [m], T [s], P [W].
/// Domain:   0 <= P < the P at which T is no longer positive (214.7 W for the published lines).
/// Traps:    the published K is a line with K(0) = 10.36 um although nothing heats at P = 0. The
///           paper is silent: here K(0) = 0, so that a standing spindle cools towards its rest,
///           with T(0).
struct DelayElement {
  Characteristic gain, time_constant;

  /// The least P [W] that it cannot take; infinite where it takes all.
  [[nodiscard]] double power_limit() const { return time_constant.positive_below(); }
  /// The displacement towards which a power P drives it [m].
  [[nodiscard]] double target(double power) const { return power > 0.0 ? gain(power) : 0.0; }
};

/// Displacement at every row [m]; P holds as the settings of the clock do. Runs begin from rest.
/// NaN from the first P on that lies outside the domain, to the end of its run. Beyond the powers
/// that were seen K and T are continued(); at P = 0 nothing heats, seen or not.
void delay_response(const Clock& clock, std::span<const double> power, const DelayElement& element,
                    std::span<double> displacement, const Interval& seen = {});

}  // namespace raceway::correction
