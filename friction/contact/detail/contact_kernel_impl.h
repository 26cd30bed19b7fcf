#pragma once

#include <xsimd/xsimd.hpp>

#include "friction/contact/detail/contact_kernel.h"
#include "friction/contact/detail/vector_math.h"

// One source file for each instruction set includes this header. Each function is templated on its
// vector type.
namespace raceway::friction::contact {

/// Integration points in single precision, with y in units of a and x in units of b.
struct KernelPoints {
  float y[most_kernel_rings][most_kernel_angles], x[most_kernel_rings][most_kernel_angles];
};

/// Intermediate values of a block: results of roll_in(), which are the inputs of slide_in(), and
/// results of slide_in(). Speeds are in units of `unit_speed`, stresses in units of Eyring's
/// stress, and lengths in units of a.
struct KernelSliding {
  alignas(64) double unit_speed[contacts_of_block], pull[contacts_of_block],
      press[contacts_of_block];
  alignas(64) float differential[contacts_of_block], spin[contacts_of_block],
      film_share[contacts_of_block], small2[contacts_of_block], limit[contacts_of_block],
      boundary[contacts_of_block], steepness[most_kernel_rings][contacts_of_block];
  KernelPoints points;
  alignas(64) float power[contacts_of_block], force[contacts_of_block], slip[contacts_of_block];
  alignas(64) float found[contacts_of_block];
};

/// Returns x^power for a number x with the logarithm `log_x`.
template <class D>
[[gnu::always_inline]] inline D power_of(const D& log_x, double power) {
  return exponential(log_x * power);
}

/// Computes film, rolling and hysteresis of one vector of contacts from index `at`, and the shear
/// law of each contact at the pressure of each integration ring.
template <class D>
void roll_in(const KernelRace& race, bool spins, std::size_t at, ContactBlock& block,
             KernelSliding& sliding) {
  const D load = D::load_aligned(block.load + at), u = D::load_aligned(block.speed + at),
          eta = D::load_aligned(block.viscosity + at),
          alpha = D::load_aligned(block.pressure_viscosity + at);
  const D log_load = logarithm(load), log_eta = logarithm(eta), log_alpha = logarithm(alpha),
          log_inlet = log_eta + logarithm(u);
  const D loading = D::load_aligned(block.loading + at) * u * u;
  // Without inlet heating the factors are 1.
  const D log_loading = logarithm(xsimd::max(loading, D(1e-100)));

  const D a = race.unit_major_axis * exponential(log_load * (1.0 / 3.0));
  const D b = a * (1.0 / race.ellipse_ratio);
  const D flooded = race.central_factor *
                    exponential(log_inlet * 0.67 + log_alpha * 0.53 - log_load * 0.067),
          least = race.minimum_factor *
                  exponential(log_inlet * 0.68 + log_alpha * 0.49 - log_load * 0.073);
  const D thermal = 1.0 / (1.0 + 0.1 * power_of(log_loading, 0.64));
  D central = flooded * thermal, minimum = least * thermal;
  if (race.starves) {
    const D log_b2 = 2.0 * logarithm(b), excess = logarithm(D(race.inlet_excess));
    const D log_reach_c = logarithm(D(race.starved_central)) + 0.58 * (logarithm(flooded) - log_b2),
            log_reach_m = logarithm(D(race.starved_minimum)) + 0.56 * (logarithm(least) - log_b2);
    central = central * power_of(xsimd::min(excess - log_reach_c, D(0.0)), 0.29);
    minimum = minimum * power_of(xsimd::min(excess - log_reach_m, D(0.0)), 0.25);
  }
  minimum.store_aligned(block.film + at);
  const D ratio = xsimd::max(minimum * (1.0 / race.roughness), D(1e-100));
  const D exponent = race.asperities_B * power_of(logarithm(ratio), race.asperities_C);
  const D share = exponential(-xsimd::min(exponent, D(690.0)));

  const D moes = race.moes_factor * exponential(log_load - 0.75 * log_inlet);
  const D rigid = race.rigid_factor *
                  (race.flooded ? exponential(log_inlet * (2.0 / 3.0) + log_load * (1.0 / 3.0))
                                : exponential(log_inlet * 0.636 + log_load * 0.364));
  const D elastic =
      race.elastic_factor *
      (race.flooded ? exponential(log_inlet * 0.75 + log_load * (1.0 / 3.0))
                    : exponential(log_inlet * 0.656 + log_load * 0.466 + log_alpha * 0.022));
  const D force = (rigid - elastic) / (1.0 + moes * (1.0 / 6.6)) + elastic;
  const D cooled = 1.0 / (1.0 + 0.29 * power_of(log_loading, 0.78));
  (2.0 * race.rolling_factor * D::load_aligned(block.supply + at) * cooled * force * u)
      .store_aligned(block.rolled + at);
  const D rolling = D::load_aligned(block.rolling + at);
  (race.hysteresis_factor * power_of(log_load, 1.33) * rolling)
      .store_aligned(block.hysteresis + at);

  const D peak = 1.5 * load / (3.14159265358979324 * a * b);
  const D differential = rolling * (0.5 / race.pressed_radius) * a * a;
  const D turning = spins ? D::load_aligned(block.spin + at) * a : D(0.0);
  const D fastest = differential + turning;
  const D unit = xsimd::select(fastest > D(0.0), fastest, D(1.0)), per_unit = 1.0 / unit;
  const D film_share = xsimd::select(central > D(0.0), 1.0 - share, D(0.0));
  const D small = 1e-6 * u * per_unit;
  const D limit = film_share * race.limiting_traction * peak * (1.0 / race.eyring_stress);
  const D edge = share * race.boundary_friction * peak * (1.0 / race.eyring_stress);
  // A share below rounding is treated as zero: at speed most contacts have no asperity contact.
  const D boundary = xsimd::select(edge > 1e-16 * limit, edge, D(0.0));
  unit.store_aligned(sliding.unit_speed + at);
  (race.copies * a * b * race.eyring_stress).store_aligned(sliding.pull + at);
  (race.copies * a * b * peak).store_aligned(sliding.press + at);

  alignas(64) double lane[D::size];
  const auto narrow = [&](const D& wide, float* to) __attribute__((always_inline)) {
    wide.store_aligned(lane);
    for (std::size_t i = 0; i < D::size; ++i) to[at + i] = static_cast<float>(lane[i]);
  };
  narrow(differential * per_unit, sliding.differential);
  narrow(turning * per_unit, sliding.spin);
  narrow(film_share, sliding.film_share);
  narrow(small * small, sliding.small2);
  narrow(limit, sliding.limit);
  narrow(boundary, sliding.boundary);
  const D log_roelands = log_eta + 9.67;
  const D Z = alpha * race.reference_pressure / log_roelands;
  const D newton =
      xsimd::select(film_share > D(0.0), eta * unit / (central * race.eyring_stress), D(0.0));
  const D pressure = peak * (1.0 / race.reference_pressure), glass = race.glass * unit;
  for (std::size_t i = 0; i < race.rings; ++i) {
    const D thicker = log_roelands * (exponential(Z * log_one_plus(pressure * race.s[i])) - 1.0);
    const D steep = newton * exponential(xsimd::select(thicker > D(690.0), D(690.0), thicker));
    narrow(xsimd::select(steep > glass, glass, steep), sliding.steepness[i]);
  }
}

/// Integrals over the points of each contact, at one v_x0 per contact; `turn` is Σ (dτ/dv) v_x.
template <class F>
struct KernelSums {
  F along, slope, force, power, turn, slip;
};

template <class F, bool film, bool asperities, bool spins>
[[gnu::always_inline]] inline KernelSums<F> sums_in(const KernelRace& race,
                                                    const KernelSliding& sliding, std::size_t at,
                                                    const F& centre) {
  const F zero(0.0f), tiny2(1e-36f);
  const F differential = F::load_aligned(sliding.differential + at),
          spin = F::load_aligned(sliding.spin + at),
          across = spin * static_cast<float>(1.0 / race.ellipse_ratio),
          share = F::load_aligned(sliding.film_share + at),
          small2 = F::load_aligned(sliding.small2 + at) + tiny2,
          limit = F::load_aligned(sliding.limit + at),
          boundary = F::load_aligned(sliding.boundary + at);
  KernelSums<F> total{zero, zero, zero, zero, zero, zero};
  for (std::size_t i = 0; i < race.rings; ++i) {
    const F steepness = F::load_aligned(sliding.steepness[i] + at);
    const F s(static_cast<float>(race.s[i])), ring_limit = limit * s, ring_boundary = boundary * s;
    KernelSums<F> ring{zero, zero, zero, zero, zero, zero};
    for (std::size_t j = 0; j < race.angles; ++j) {
      const F y(sliding.points.y[i][j]);
      const F vx = centre + (differential * y - spin) * y;
      F v2 = vx * vx, per_v = zero, v;
      if constexpr (spins) {
        const F vy = across * F(sliding.points.x[i][j]);
        v2 = v2 + vy * vy;
        per_v = inverse_root(v2 + tiny2);
        v = v2 * per_v;
      } else {
        v = xsimd::abs(vx);
      }
      F stress = zero, tangent = zero;
      if constexpr (film) {
        const F z = steepness * v, square = z * z + 1.0f, per_length = inverse_root(square);
        const F sheared = share * area_sine(z, square * per_length);
        const auto limited = sheared > ring_limit;
        stress = xsimd::select(limited, ring_limit, sheared);
        tangent = xsimd::select(limited, zero, share * steepness * per_length);
      }
      if constexpr (asperities) {
        const F per_root = inverse_root(v2 + small2), edge = ring_boundary * per_root;
        stress = stress + edge * v;
        tangent = tangent + edge * (small2 * (per_root * per_root));
      }
      ring.force = ring.force + stress;
      ring.power = ring.power + stress * v;
      ring.turn = ring.turn + tangent * vx;
      ring.slip = ring.slip + v;
      if constexpr (spins) {
        const F direction = vx * per_v, squared = direction * direction;
        ring.along = ring.along + stress * direction;
        ring.slope = ring.slope + (stress * per_v) * (1.0f - squared) + tangent * squared;
      } else {
        ring.along = ring.along + xsimd::copysign(stress, vx);
        ring.slope = ring.slope + tangent;
      }
    }
    const F weight(static_cast<float>(race.weight[i]));
    total.along = total.along + weight * ring.along;
    total.slope = total.slope + weight * ring.slope;
    total.force = total.force + weight * ring.force;
    total.power = total.power + weight * ring.power;
    total.turn = total.turn + weight * ring.turn;
    total.slip = total.slip + weight * s * ring.slip;
  }
  return total;
}

/// Solves Σ τ_x = 0 for each contact by Newton's method within a bracket. The search ends when |Σ
/// τ_x| is at most 3e-4 Σ |τ|. The power is then extrapolated linearly to Σ τ_x = 0. The search
/// also ends when the bracket is 5e-4 of its initial width, because Σ τ_x jumps where the slip of a
/// point changes direction; there the power hardly depends on v_x0. If a Newton step does not halve
/// Σ τ_x, the chord of the bracket replaces the step.
template <class F, bool film, bool asperities, bool spins>
void slide_in(const KernelRace& race, std::size_t at, KernelSliding& sliding) {
  const F zero(0.0f);
  F low = -F::load_aligned(sliding.differential + at), high = zero;
  const F narrow = 5e-4f * (high - low);
  // The zero of pure dry friction is at 0.121 of the range, or at 0.01 if spin dominates. The zero
  // of a film is close to these values.
  F start(0.121f);
  if constexpr (spins)
    start = xsimd::select(F::load_aligned(sliding.film_share + at) > F(0.5f), F(0.1f), F(0.01f));
  F v = start * low, before(3e38f), below(-1.0f), above(1.0f);
  F power = zero, force = zero, slip = zero;
  auto done = zero > zero;
  for (int step = 0; step < 60; ++step) {
    const KernelSums<F> f = sums_in<F, film, asperities, spins>(race, sliding, at, v);
    // Until the forces at the ends of the bracket are known, half of the largest possible force is
    // used.
    if (step == 0) {
      below = -0.5f * f.force;
      above = 0.5f * f.force;
    }
    const auto forwards = f.along > zero;
    high = xsimd::select(forwards, v, high);
    low = xsimd::select(forwards, low, v);
    above = xsimd::select(forwards, f.along, above);
    below = xsimd::select(forwards, below, f.along);
    const F back = f.along / f.slope, newton = v - back, size = xsimd::abs(f.along);
    const auto inside = newton > low && newton < high;
    const auto at_zero = inside && size <= 3e-4f * f.force;
    const auto now = !done && (at_zero || !(high - low > narrow));
    power =
        xsimd::select(now, f.power - xsimd::select(at_zero, f.turn + f.along, zero) * back, power);
    force = xsimd::select(now, f.force, force);
    slip = xsimd::select(now, f.slip, slip);
    done = done || now;
    if (xsimd::all(done)) break;
    if (step % 4 == 3) below = -above;  // bisection, if chords are slow
    const F part = xsimd::min(xsimd::max(below / (below - above), F(0.1f)), F(0.9f));
    v = xsimd::select(inside && size < 0.5f * before, newton, low + part * (high - low));
    before = size;
  }
  power.store_aligned(sliding.power + at);
  force.store_aligned(sliding.force + at);
  slip.store_aligned(sliding.slip + at);
  // Beyond this limit the squares in the search overflow single precision.
  const auto found = done && F::load_aligned(sliding.steepness[0] + at) < F(1e18f);
  xsimd::select(found, F(1.0f), zero).store_aligned(sliding.found + at);
}

template <class F>
void slide_all(const KernelRace& race, bool spins, KernelSliding& sliding) {
  bool film = false, asperities = false;
  for (std::size_t i = 0; i < contacts_of_block; ++i) {
    film = film || sliding.film_share[i] > 0.0f;
    asperities = asperities || sliding.boundary[i] > 0.0f;
  }
  for (std::size_t at = 0; at < contacts_of_block; at += F::size) {
    if (film && asperities)
      spins ? slide_in<F, true, true, true>(race, at, sliding)
            : slide_in<F, true, true, false>(race, at, sliding);
    else if (film)
      spins ? slide_in<F, true, false, true>(race, at, sliding)
            : slide_in<F, true, false, false>(race, at, sliding);
    else
      spins ? slide_in<F, false, true, true>(race, at, sliding)
            : slide_in<F, false, true, false>(race, at, sliding);
  }
}

template <class Set>
void contact_kernel_in(const KernelRace& race, bool spins, ContactBlock* blocks,
                       std::size_t count) {
  using D = xsimd::batch<double, Set>;
  using F = xsimd::batch<float, Set>;
  KernelSliding sliding;
  for (std::size_t i = 0; i < race.rings; ++i)
    for (std::size_t j = 0; j < race.angles; ++j) {
      sliding.points.y[i][j] = static_cast<float>(race.radius[i] * race.sine[j]);
      sliding.points.x[i][j] = static_cast<float>(race.radius[i] * race.cosine[j]);
    }
  for (ContactBlock* block = blocks; block != blocks + count; ++block) {
    for (std::size_t at = 0; at < contacts_of_block; at += D::size)
      roll_in<D>(race, spins, at, *block, sliding);
    slide_all<F>(race, spins, sliding);
    for (std::size_t i = 0; i < contacts_of_block; ++i) {
      const double per_load = 1.0 / block->load[i];
      block->sliding[i] = sliding.pull[i] * sliding.unit_speed[i] * sliding.power[i];
      block->friction[i] = sliding.pull[i] * per_load * sliding.force[i];
      block->slip[i] = sliding.press[i] * per_load * sliding.unit_speed[i] * sliding.slip[i];
      block->found[i] = sliding.found[i];
    }
  }
}

}  // namespace raceway::friction::contact
