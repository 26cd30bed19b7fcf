#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Instruction sets of a processor, for 2, 4 or 8 operating points in parallel.
enum class InstructionSet { sse2, avx2, avx512 };

[[nodiscard]] std::string_view name(InstructionSet set);
/// Returns the widest instruction set of this machine.
[[nodiscard]] InstructionSet best_instruction_set();
[[nodiscard]] bool available(InstructionSet set);

/// Operating point together with its bearing. Cases with different Bearing objects, such as one
/// bearing at several temperatures, can be solved in the same SIMD batch if the bearings have equal
/// numbers of balls.
struct BearingCase {
  const Bearing* bearing = nullptr;
  OperatingPoint point;
};

/// Finds the equilibria of many operating points. The solution of one point is never the start
/// value of another point. Each status equals the status from solve_bearing_equilibrium(), and the
/// solutions agree within the tolerance. There is one exception: under inner control, one load can
/// have several equilibria, and because of rounding, different instruction sets can find different
/// equilibria.
///
/// Newton's method solves several points in parallel (SIMD), starting from the approximate solution
/// for pure thrust. Points without positive axial load, points with given rotations, and points
/// that do not converge in this way are solved one by one. The result of a point depends only on
/// the point and the instruction set, not on the number of threads or on the other points. Repeated
/// calls give equal results to the last bit. The function needs memory for the results and a fixed
/// amount of memory for each thread. If `results` has memory from an earlier call, the function
/// uses this memory again.
///
/// Throws std::invalid_argument if the number of results differs from the number of points, if a
/// point is outside the range of validate(), or if the processor does not support `set`.
void solve_many(const Bearing& bearing, std::span<const OperatingPoint> points,
                std::span<BearingEquilibrium> results, const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());
void solve_many(std::span<const BearingCase> cases, std::span<BearingEquilibrium> results,
                const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());

/// Solves many points without storing all results. The function calls `take` once for each point,
/// with the index and the equilibrium of the point. Several threads call `take` at the same time.
/// The memory use does not grow with the number of points.
void visit_equilibria(const Bearing& bearing, std::span<const OperatingPoint> points,
                      const std::function<void(std::size_t, const BearingEquilibrium&)>& take,
                      const EquilibriumOptions& options = {},
                      InstructionSet set = best_instruction_set());

}  // namespace raceway::bearing
