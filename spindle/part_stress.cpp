#include "spindle/part_stress.h"

#include <cmath>
#include <stdexcept>

namespace raceway::spindle {
namespace {

/// ∫ T r dr between two places of a profile, temperatures above `reference` [K m²].
double moment_between(const RadialTemperature& from, const RadialTemperature& to,
                      double reference) {
  const double t0 = from.temperature - reference, t1 = to.temperature - reference;
  const double r0 = from.radius, r1 = to.radius, squares = r1 * r1 - r0 * r0;
  if (!(r0 > 0.0)) return 0.5 * t1 * squares;
  return 0.5 * t0 * squares + (t1 - t0) * (0.5 * r1 * r1 - 0.25 * squares / std::log(r1 / r0));
}

void validate_profile(const std::vector<RadialTemperature>& profile) {
  if (profile.size() < 2 || !(profile.front().radius >= 0.0))
    throw std::invalid_argument(
        "profile: at least two radii are needed, and the first radius must be 0 m or more");
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
    if (!(profile[k].radius < profile[k + 1].radius))
      throw std::invalid_argument("profile: the radii must be in ascending order");
}

}  // namespace

std::vector<Stress> stresses_of(const RoundPart& part) {
  const std::vector<RadialTemperature>& profile = part.profile;
  validate_profile(profile);
  const model::SolidMaterial& m = part.material;
  const double nu = m.poissons_ratio;
  const double a = profile.front().radius, b = profile.back().radius;
  const double aa = a * a, bb = b * b, wall = bb - aa;
  // An even temperature then gives no stress, to the last digit.
  const double reference = profile.back().temperature;
  std::vector<double> moment{0.0};
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
    moment.push_back(moment.back() + moment_between(profile[k], profile[k + 1], reference));
  const double mean = 2.0 * moment.back() / wall;

  const double heat = m.elastic_modulus * m.thermal_expansion / (1.0 - nu);
  const double inertia = m.density * part.speed * part.speed / (1.0 - nu);
  const double turning = inertia * (3.0 - 2.0 * nu) / 8.0;
  const double even = (part.bore_pressure * aa - part.surface_pressure * bb) / wall;
  const double squeeze = (part.bore_pressure - part.surface_pressure) * bb / wall;

  std::vector<Stress> list;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const double r = profile[k].radius, rr = r * r;
    const bool axis = !(r > 0.0);
    // On the axis of a full cylinder the temperature is that of the first layer.
    const double t = (axis ? profile[k + 1] : profile[k]).temperature - reference;
    const double here = axis ? 0.5 * t : moment[k] / rr;  // J/r²
    const double hole = axis ? 0.0 : aa / rr;
    Stress s{.radius = r};
    s.radial = heat * (0.5 * (1.0 - hole) * mean - here) + even - squeeze * hole +
               turning * (aa + bb - hole * bb - rr);
    s.hoop = heat * (0.5 * (1.0 + hole) * mean + here - t) + even + squeeze * hole +
             turning * (aa + bb + hole * bb - (1.0 + 2.0 * nu) / (3.0 - 2.0 * nu) * rr);
    s.axial = heat * (mean - t) + 0.5 * inertia * nu * (0.5 * (aa + bb) - rr);
    list.push_back(s);
  }
  return list;
}

}  // namespace raceway::spindle
