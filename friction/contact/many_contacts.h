#pragma once

#include <span>

#include "bearing/solve_many.h"
#include "friction/contact/contact_law.h"

namespace raceway::friction::contact {

/// Vectorized contact_result() for many states of one bearing, with the same laws and integration
/// points.
///
/// If all states refer to the same bearing and the same ContactData, the result of a state does not
/// depend on the other states, not even in the last digit. States at standstill, without
/// equilibrium or without race control are computed without vectorization. The states are processed
/// in blocks of 256. A state whose bearing or ContactData differs from the first state of its block
/// is also computed without vectorization.
/// Memory:   each thread keeps a fixed amount of memory between calls.
/// Accuracy: relative differences from contact_result() are as follows. Film, rolling and
///           hysteresis agree to 1e-11. The sliding loss is computed in single precision. For the
///           sliding loss, the largest difference in 4000 random states is 2e-4, and the difference
///           in most states is below 1e-6. The friction torque of a rotating 7014 bearing agrees to
///           5e-7. `mean_slip` agrees to 5e-4, and `holding_over_traction` agrees to 2 %.
/// Throws std::invalid_argument if the numbers of states and results differ, or if the machine does
/// not support the instruction set `set`.
void contact_results(std::span<const BearingState<double>> states, std::span<const double> values,
                     std::span<ContactResult> results,
                     bearing::InstructionSet set = bearing::best_instruction_set());

/// Output of friction_of_many(). Each span has one element per operating point. To omit a result,
/// leave its span empty.
struct FrictionColumns {
  std::span<double> torque{};  ///< friction moment of the bearing [N m]
  /// Contributions to the friction moment [N m].
  std::span<double> rolling{}, sliding{}, hysteresis{}, drag{};
  std::span<double> inner_heat{}, outer_heat{};  ///< friction heat, see ring_heat() [W]
  std::span<double> smallest_film{};             ///< smallest h_min of all contacts [m]
  std::span<double> smallest_film_ratio{};       ///< smallest film ratio Λ of all contacts [1]
  std::span<double> kinematic_viscosity{};       ///< kinematic viscosity at the temperature of the
                                                 ///< operating point [m²/s]
  /// Equivalent ball loads of the races for the life by ISO/TS 16281 [N]: Q_ei = (Σ Q^3/Z)^(1/3)
  /// for the rotating inner ring, Q_ee = (Σ Q^(10/3)/Z)^(3/10) for the stationary outer ring. Q is
  /// the contact load of one ball, and Z the number of balls.
  std::span<double> inner_equivalent_load{}, outer_equivalent_load{};
};

/// Bearing, lubricant and other inputs of friction_of_many() that are the same for all operating
/// points.
struct FrictionOfMany {
  const bearing::Bearing* bearing = nullptr;
  const Lubricant* lubricant = nullptr;
  const ContactData* data = nullptr;
  std::span<const double> values;  ///< parameter values in the order of contact_parameters
};

/// Computes equilibrium and friction of one bearing at many operating points (speed, loads,
/// temperature), in parallel on several threads. All values of a point without equilibrium are NaN.
/// Domain:   as for solve_bearing_equilibrium() and Lubricant. Accuracy: as for contact_results().
/// Throws std::invalid_argument if a non-empty span does not have one element per point, or if a
/// point is out of range.
void friction_of_many(const FrictionOfMany& asked, std::span<const bearing::OperatingPoint> points,
                      const FrictionColumns& columns,
                      const bearing::EquilibriumOptions& options = {},
                      bearing::InstructionSet set = bearing::best_instruction_set());

}  // namespace raceway::friction::contact
