#pragma once

#include <cmath>

#include "record/units.h"

namespace raceway::friction::contact {

/// Viscosity of an oil under pressure [Pa s].
///
///   η(p) = η0 exp(L ((1 + p/1.96e8)^Z - 1)),   L = ln η0 + 9.67,   Z = α 1.96e8/L
///
/// η0 is the viscosity at ambient pressure and α the pressure-viscosity coefficient. The slope of
/// ln η at zero pressure is α, as in Barus' law. Above about 0.1 GPa the viscosity rises more
/// slowly than in Barus' law.
/// Source:   Roelands 1966, also in textbooks such as [Hamrock1994]. These sources were not
///           checked; the formula was taken from a published report on roller bearings.
/// Domain:   p >= 0, α > 0 and η0 above e^-9.67 Pa s = 0.063 mPa s. For a lower η0, the result is
///           NaN (see roelands_holds()).
/// Accuracy: the viscosity is accurate to 10 % up to 0.5 GPa. Above 1 GPa the oil behaves like a
///           glass, see shear.h.
class Roelands {
 public:
  Roelands(double viscosity, double pressure_viscosity)
      : viscosity_(viscosity), log_(std::log(viscosity) + 9.67) {
    exponent_ = log_ > 0.0 ? pressure_viscosity * reference_pressure / log_ : unset;
  }

  [[nodiscard]] double operator()(double pressure) const {
    return viscosity_ *
           std::exp(log_ * (std::pow(1.0 + pressure / reference_pressure, exponent_) - 1.0));
  }

  /// η0 of the formula [Pa s].
  [[nodiscard]] double at_no_pressure() const { return viscosity_; }
  /// L of the formula [1].
  [[nodiscard]] double logarithm() const { return log_; }
  /// Z of the formula [1].
  [[nodiscard]] double exponent() const { return exponent_; }

  static constexpr double reference_pressure = 1.96e8;  ///< [Pa]

 private:
  double viscosity_, log_, exponent_;
};

/// True if Roelands' law gives a finite viscosity for an oil with this η0 [Pa s]. η0 must be above
/// e^-9.67 Pa s, which is true for all lubricants.
[[nodiscard]] inline bool roelands_holds(double viscosity) {
  return std::log(viscosity) + 9.67 > 0.0;
}

}  // namespace raceway::friction::contact
