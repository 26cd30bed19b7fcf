#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Axial contraction of the turning shaft between the front set and the point at which the position
/// is measured [m].
///
///   u_read = u - c (n/10 000 rpm)²,   c = L ν ρ ω² (a² + b²)/(2 E) at 10 000 rpm
///
/// u_read is the measured axial displacement, and u the displacement without contraction. n is the
/// speed, and ω the angular speed at 10 000 rpm. L is the length of the shaft between these two
/// points, and a and b are its inner and outer radius. ν, ρ and E are Poisson's ratio, density and
/// elastic modulus. The tool side of the shaft moves backwards, so the measured displacement is
/// smaller than u.
///
/// Source:   derived without solving for the stresses. The radial equilibrium is
///           d(r² σ_r)/dr = r (σ_r + σ_θ) - ρ ω² r³. With no pressure at the radii a and b, the
///           integral of the equilibrium gives ρ ω² (a² + b²)/2 as the mean of σ_r + σ_θ over the
///           section. Without axial force, the mean axial strain is -ν/E times the mean of
///           σ_r + σ_θ. Example: a steel shaft with a = 15 mm and b = 35 mm contracts by 9 um per
///           metre at 10 000 rpm.
/// Domain:   every speed; the contraction follows the speed without lag. The shaft between the
///           bearing sets contracts too, which changes the load of the sets. The model neglects
///           this change of load, because it does not contain the radii of the shaft.
struct ShaftContraction {
  static constexpr std::string_view id = "shaft-contraction";
  static constexpr std::string_view title = "shortening of the shaft with speed";
  static constexpr std::string_view mechanism =
      "Centrifugal force expands the shaft radially. The shaft therefore becomes shorter "
      "(Poisson's ratio), with the square of speed and without delay. The nose of the shaft "
      "moves back, away from the workpiece.";
  static constexpr std::string_view formula =
      "u_read = u - c (n/10000 rpm)^2, c = L nu rho w^2 (a^2 + b^2)/(2 E) (n: speed, L: "
      "length of the shaft from the front set to the measured point, a and b: inner and "
      "outer radius of the shaft, nu: Poisson's ratio, rho: density, E: elastic modulus, w: "
      "angular speed at 10000 rpm)";
  static constexpr std::string_view source = "rotating hollow shaft without axial force, derived";
  static constexpr std::array<std::string_view, 4> confused_with{
      "centrifugal-ring-growth", "thermal-preload", "mounting", "preload_N"};
  static constexpr std::array parameters{Parameter{.name = "contraction_at_10000_rpm_um",
                                                   .unit = "um",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 100.0,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 5.0}};
  static constexpr std::array needs{Need::speed_levels, Need::preload_levels};
  static constexpr const record::Channel& channel = record::axial_displacement;

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    const double ratio = in.point.speed / (10000.0 * rpm);
    return -values[0] * um * ratio * ratio;
  }
};

}  // namespace raceway::effects
