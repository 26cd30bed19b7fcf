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

/// An operating point of a bearing. Different Bearing objects, for example for the same bearing at
/// several temperatures, can be solved in the same SIMD batch if they have equal numbers of balls.
struct BearingCase {
  const Bearing* bearing = nullptr;
  OperatingPoint point;
};

/// Finds the equilibria of many operating points. No point starts from the solution of another
/// point. The statuses equal the statuses of solve_bearing_equilibrium(), and the solutions agree
/// within the tolerance. There is one exception: under inner control one load can have several
/// equilibria, and rounding can lead each instruction set to a different one.
///
/// Newton's method solves several points in parallel (SIMD), from the closed-form thrust solution.
/// Points at which this method does not converge, points without positive axial load, and points
/// with given rotations are solved like single points. Threads share the points in fixed chunks.
/// The result of a point depends only on the point and the instruction set, to the last bit. The
/// number of threads has no influence. The function needs memory for the results and a fixed amount
/// per thread. Memory for balls that `results` already contains is used again.
///
/// Throws std::invalid_argument if the number of results differs from the number of points, for
/// points that are out of range, and if the machine does not support `set`.
void solve_many(const Bearing& bearing, std::span<const OperatingPoint> points,
                std::span<BearingEquilibrium> results, const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());
void solve_many(std::span<const BearingCase> cases, std::span<BearingEquilibrium> results,
                const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());

/// Solves many points for callers that keep only a few values of each point. Several threads call
/// `take` with the index of a point and its equilibrium, once for each index. Memory does not grow
/// with the number of points.
void visit_equilibria(const Bearing& bearing, std::span<const OperatingPoint> points,
                      const std::function<void(std::size_t, const BearingEquilibrium&)>& take,
                      const EquilibriumOptions& options = {},
                      InstructionSet set = best_instruction_set());

}  // namespace raceway::bearing
