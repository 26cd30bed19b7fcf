#pragma once

#include <span>

#include "bearing/solve_many.h"
#include "friction/contact/contact_law.h"

namespace raceway::friction::contact {

/// Vectorized contact_result() for many states of one bearing: the same laws, points and statuses.
///
/// All states should refer to the same bearing and the same ContactData. The function computes a
/// state separately if it refers to another bearing or ContactData than the first state, if it is
/// at standstill, or if it has no equilibrium or no race control. A result depends only on its
/// state and the instruction set, to the last bit.
/// Memory: a fixed amount for each thread, kept between calls. States need no additional memory.
/// Accuracy: compared with contact_result(), film, rolling and hysteresis agree to 1e-11. Sliding
///           uses the same points in single precision. Sliding agrees to 2e-4 in the worst of 4000
///           random states, and to 1e-6 in most of these states (5e-7 of the torque of a 7014 at
///           speed). Slip agrees to 5e-4, and `holding_over_traction` agrees to 2 %.
/// Throws std::invalid_argument if the sizes differ or the machine lacks the instructions (avx512
/// uses the kernels of avx2).
void contact_results(std::span<const BearingState<double>> states, std::span<const double> values,
                     std::span<ContactResult> results,
                     bearing::InstructionSet set = bearing::best_instruction_set());

/// Output of friction_of_many(): one number per point; an empty span is not filled.
struct FrictionColumns {
  std::span<double> torque{};  ///< [N m]
  /// Parts of the friction moment [N m].
  std::span<double> rolling{}, sliding{}, hysteresis{}, drag{};
  std::span<double> inner_heat{}, outer_heat{};  ///< [W]
  std::span<double> smallest_film{};             ///< h_min [m]
  std::span<double> smallest_film_ratio{};       ///< Λ [1]
  std::span<double> kinematic_viscosity{};       ///< viscosity of the oil at the point [m²/s]
  /// Equivalent loads of the races [N], which together with `kinematic_viscosity` determine the
  /// life by ISO/TS 16281: Q_ei = (Σ Q^3/Z)^(1/3) for the rotating inner ring, Q_ee = (Σ
  /// Q^(10/3)/Z)^(3/10) for the stationary outer ring.
  std::span<double> inner_equivalent_load{}, outer_equivalent_load{};
};

/// Inputs of friction_of_many() in addition to the operating points.
struct FrictionOfMany {
  const bearing::Bearing* bearing = nullptr;
  const Lubricant* lubricant = nullptr;
  const ContactData* data = nullptr;
  std::span<const double> values;  ///< values of contact_parameters
};

/// Equilibrium and friction of one bearing at many operating points (speed, loads, temperature),
/// shared among threads in fixed chunks. The values of a point without equilibrium are NaN.
/// Domain:   as for solve_bearing_equilibrium() and Lubricant. Accuracy: as contact_results().
/// Throws std::invalid_argument if a non-empty span does not have one number per point, or for
/// points that are out of range.
void friction_of_many(const FrictionOfMany& asked, std::span<const bearing::OperatingPoint> points,
                      const FrictionColumns& columns,
                      const bearing::EquilibriumOptions& options = {},
                      bearing::InstructionSet set = bearing::best_instruction_set());

}  // namespace raceway::friction::contact
