#pragma once

#include <cstddef>

namespace raceway::friction::contact {

// Interface of film_traction.cpp to traction_pass_*.cpp, which contain the same code compiled for
// each instruction set.

/// Points of the unit circle in rows of sixteen for vectorization. If the ball spins, a row
/// contains the points of one ring at sixteen angles. If it does not spin, a row contains the
/// points of sixteen rings at one angle. Then only points at y > 0 are stored, because their mirror
/// images at y < 0 have the same slip.
inline constexpr std::size_t side_by_side = 16;
inline constexpr std::size_t most_rings = 16;

template <typename Real>
struct CirclePoints {
  std::size_t rings, rows;
  /// Position of each point in units of b and a [1].
  alignas(64) Real x[most_rings][side_by_side], y[most_rings][side_by_side];
  /// Weight of a point of each ring, as in EllipsePoints, and s = p/p0 [1].
  alignas(64) Real weight[most_rings], s[most_rings];
};

/// Slip field of a contact, and its shear law at the pressure of each ring. Speeds are divided by
/// the largest slip, stresses by Eyring's stress, and lengths by a.
template <typename Real>
struct RingStresses {
  Real differential, spin, width, film_share, small2;
  alignas(64) Real steepness[most_rings], limit[most_rings], boundary[most_rings];
};

/// Inputs for the shear law of all rings, as in FilmShear::at_pressure(): constants of Roelands'
/// viscosity, and values at the peak pressure. For each ring, `pressure`, `limit` and `boundary`
/// are multiplied by its s.
struct RingPressures {
  double logarithm, exponent, pressure, newton, glass, limit, boundary;
};

struct PassSums {
  double along = 0.0, slope = 0.0, force = 0.0, power = 0.0, moment = 0.0, slip = 0.0;
};

/// Friction mechanisms in a contact: film, asperities or both.
enum class Rubbing { film, asperities, both };

/// The kernels of one instruction set. `stresses` computes the shear law of each ring. `search`
/// computes `along`, `slope` and `force` in single precision. `sum` computes all values in double
/// precision; its slope is only accurate enough for a search.
struct TractionKernel {
  void (*stresses)(const CirclePoints<double>&, const RingPressures&, RingStresses<double>&,
                   RingStresses<float>&);
  PassSums (*search)(const CirclePoints<float>&, const RingStresses<float>&, Rubbing, bool spins,
                     double centre);
  PassSums (*sum)(const CirclePoints<double>&, const RingStresses<double>&, Rubbing, bool spins,
                  double centre);
};
TractionKernel traction_kernel_sse2();
TractionKernel traction_kernel_avx2();
TractionKernel traction_kernel_avx512();

}  // namespace raceway::friction::contact
