#pragma once

#include <array>
#include <numbers>

namespace raceway::spindle {

/// Coefficients of the time integration method TR-BDF2 with γ = 2 - √2. For dT/dt = f, TR-BDF2 is a
/// three-stage Runge-Kutta method with an explicit first stage:
///
///   T_γ = T_0 + dt d (f_0 + f_γ)
///   T_1 = T_0 + dt (w f_0 + w f_γ + d f_1),     d = γ/2,  w = √2/4
///
/// f_0, f_γ and f_1 are the values of f at T_0, T_γ and T_1. Both implicit stages solve linear
/// equations with the matrix C + dt d G, where C contains heat capacities and G conductances. The
/// method conserves heat: the stored heat C (T_1 - T_0) is exactly dt times the weighted mean of
/// the heat flows in the three stages.
/// Source:   Bank et al. 1985; Hosea and Shampine (Appl Numer Math 20, 1996, p. 21), who give the
///           embedded weights of order 3.
/// Accuracy: order 2; A-stable, and L-stable because amplification() also tends to 0 for z -> -inf.
struct TrBdf2 {
  static constexpr double gamma = 2.0 - std::numbers::sqrt2;
  static constexpr double diagonal = 0.5 * gamma;
  static constexpr double weight = 0.25 * std::numbers::sqrt2;
  static constexpr std::array<double, 3> weights{weight, weight, diagonal};
  /// Weights of the error estimate: `weights` minus the weights of the embedded method of order 3.
  static constexpr std::array<double, 3> error_weights{weight - (1.0 - weight) / 3.0,
                                                       weight - (3.0 * weight + 1.0) / 3.0,
                                                       diagonal - diagonal / 3.0};

  /// Returns the ratio T_1/T_0 of one step for dT/dt = λ T, with z = λ dt [1].
  [[nodiscard]] static constexpr double amplification(double z) {
    const double middle = (1.0 + diagonal * z) / (1.0 - diagonal * z);
    return (1.0 + weight * z + weight * z * middle) / (1.0 - diagonal * z);
  }
};

}  // namespace raceway::spindle
