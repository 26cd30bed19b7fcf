#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Instructions that a processor may have: 2, 4 or 8 operating points side by side.
enum class InstructionSet { sse2, avx2, avx512 };

[[nodiscard]] std::string_view name(InstructionSet set);
/// Returns the widest instruction set that this machine can run.
[[nodiscard]] InstructionSet best_instruction_set();
[[nodiscard]] bool available(InstructionSet set);

/// An operating point of a bearing. Different bearings, for example one at several temperatures,
/// are solved side by side where they have as many balls.
struct BearingCase {
  const Bearing* bearing = nullptr;
  OperatingPoint point;
};

/// Equilibria of many operating points, each from a cold start, as solve_bearing_equilibrium()
/// finds them one by one: the same statuses, and the same solution within the tolerance. (Under
/// inner control, where one load can have several states of balance, the rounding of another
/// instruction set can lead to another of them.)
///
/// Points are solved in SIMD lanes where Newton's method converges from the thrust start; others
/// are handed to the search that a single solve has. Threads share fixed chunks. The result of a
/// point depends on nothing but itself and the instruction set: neither on the other points nor on
/// the number of threads, to the last bit. Memory: the results, and a fixed amount per thread;
/// results that already have room for their balls are filled without allocation.
///
/// Throws std::invalid_argument if the sizes differ, or for points that are out of range.
void solve_many(const Bearing& bearing, std::span<const OperatingPoint> points,
                std::span<BearingEquilibrium> results, const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());
void solve_many(std::span<const BearingCase> cases, std::span<BearingEquilibrium> results,
                const EquilibriumOptions& options = {},
                InstructionSet set = best_instruction_set());

/// Solves for callers that keep a few numbers of each point: several threads call `take` with the
/// index of a point and its equilibrium, each index once. Memory does not grow with the number of
/// points.
void visit_equilibria(const Bearing& bearing, std::span<const OperatingPoint> points,
                      const std::function<void(std::size_t, const BearingEquilibrium&)>& take,
                      const EquilibriumOptions& options = {},
                      InstructionSet set = best_instruction_set());

}  // namespace raceway::bearing
