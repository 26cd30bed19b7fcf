#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bearing/hertz.h"
#include "bearing/material.h"
#include "record/units.h"

namespace raceway::bearing {

/// Crowning of the rollers.
enum class RollerProfile {
  iso,  ///< logarithmic, as in ISO/TS 16281
  none  ///< straight cylinders
};

/// State of the bearing for which the radial clearance is given.
enum class ClearanceState {
  mounted,  ///< mounted on its seats, cold and at standstill
  free      ///< before mounting
};

/// Internal geometry of a single-row cylindrical roller bearing that is free to move axially.
struct RollerGeometry {
  int roller_count = 0;            ///< Z [1]
  double roller_diameter = unset;  ///< D [m]
  double roller_length = unset;    ///< L, effective length without the chamfers [m]
  double pitch_diameter = unset;   ///< d_m [m]
  double radial_clearance = 0.0;   ///< diametral clearance s [m]; a negative value is a preload
  ClearanceState clearance_state = ClearanceState::mounted;
  double taper = 0.0;  ///< taper of the bore: 12 for 1:12, 0 for a cylindrical bore [1]
  RollerProfile profile = RollerProfile::iso;
  double bore = unset;                ///< d [m]; may be unknown
  double outer_diameter = unset;      ///< diameter of the outer ring [m]; may be unknown
  double width = unset;               ///< width B [m]; may be unknown
  double static_load_rating = unset;  ///< C0 [N]; if NaN, life::static_load_rating() computes C0

  /// γ = D/d_m [1].
  [[nodiscard]] double diameter_ratio() const { return roller_diameter / pitch_diameter; }
  /// Diameter of a raceway [m]: d_m - D at the inner ring, d_m + D at the outer ring.
  [[nodiscard]] double raceway_diameter(Race race) const {
    return pitch_diameter + (race == Race::inner ? -roller_diameter : roller_diameter);
  }
};

/// Checks and returns the geometry. Throws std::invalid_argument for the first missing or
/// impossible value. The message gives name, value and allowed range.
[[nodiscard]] RollerGeometry validated(const RollerGeometry& geometry);

/// Number of slices (laminae) of a roller. The number is fixed, because the life depends on this
/// number through the edge stress factor of ISO/TS 16281. The number is odd, so that one slice lies
/// in the middle of the roller.
inline constexpr std::size_t lamina_count = 41;

/// Profile relief of a roller at the distance x from its middle [m].
///
///   P = 0.00035 D ln(1/(1 - (2x/L)²))                          L <= 2.5 D
///   P = 0.0005 D ln(1/(1 - ((2|x| - L + 2.5 D)/(2.5 D))²))     L > 2.5 D, |x| > (L - 2.5 D)/2
///
/// P is zero in the straight middle of a long roller, and for RollerProfile::none.
/// Source:   [ISO16281], not checked against the printed standard. Two other programs use the first
///           formula. The second formula was written without a copy of the standard. One of the two
///           programs sets the brackets of the second formula differently, so the position of the
///           brackets is uncertain.
/// Domain:   |x| < L/2.
[[nodiscard]] double roller_relief(const RollerGeometry& geometry, double x);

/// Line contact between one slice of a roller and a raceway.
///
///   q = c1 δ^(10/9),   c1 = 2^(10/9) cs,   cs = 35948 L^(8/9)/ns   [N, mm]
///
/// The number 35948 is valid for forces in N and lengths in mm. q is the load of one slice at one
/// race, δ is the approach of slice and race, and ns is lamina_count. cs is the stiffness of both
/// contacts of a slice in series, and c1 is the stiffness of a single contact. For materials other
/// than steel, cs and c1 are multiplied by 2 k(steel)/(k(roller) + k(ring)), k = (1 - ν²)/E.
///
/// Source:   [ISO16281], as two other programs implement it. Two parts are derived here: the split
///           into two equal contacts in series, and the factor for other materials. The factor for
///           other materials follows from Lundberg's formula, in which the load occurs only as a
///           product with k.
/// Accuracy: the approach is within 2.5 % of a boundary element solution for the contact of a strip
///           and a cylinder. Palmgren's formula 3.84e-5 Q^0.9/L^0.8 gives an approach that is 3.4 %
///           smaller.
/// Trap:     the constant 35948 of ISO/TS 16281 is for both contacts in series, but the constant
///           3.84e-5 of Palmgren is for one contact.
struct LineContact {
  double stiffness = unset;     ///< c1 of one slice at one race [N/m^(10/9)]
  double compliance = unset;    ///< k1 + k2, sum of k = (1 - ν²)/E of roller and ring [1/Pa]
  double inner_radius = unset;  ///< R, equivalent radius at the inner raceway, D/2 (1 - D/d_m) [m]
  double outer_radius = unset;  ///< equivalent radius at the outer raceway, D/2 (1 + D/d_m) [m]

  [[nodiscard]] double radius(Race race) const {
    return race == Race::inner ? inner_radius : outer_radius;
  }
  /// Half width b = sqrt(4 w R (k1 + k2)/π) [m] under a load per length w [N/m].
  [[nodiscard]] double half_width(Race race, double line_load) const {
    return std::sqrt(4.0 * line_load * radius(race) * compliance / pi);
  }
  /// Largest Hertz pressure, p = 2 w/(π b) [Pa]; 0 without load.
  [[nodiscard]] double peak_pressure(Race race, double line_load) const {
    return std::sqrt(line_load / (pi * radius(race) * compliance));
  }
};

/// Immutable cylindrical roller bearing for the solvers: checked geometry, materials and derived
/// constants.
class RollerBearing {
 public:
  /// Throws std::invalid_argument in the same cases as validated(geometry) and validate(material).
  RollerBearing(const RollerGeometry& geometry, const Material& rollers, const Material& rings);

  [[nodiscard]] const RollerGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const Material& rollers() const { return rollers_; }
  [[nodiscard]] const Material& rings() const { return rings_; }
  [[nodiscard]] const LineContact& contact() const { return contact_; }
  /// Mass of a roller, m = ρ π/4 D² L [kg].
  [[nodiscard]] double roller_mass() const { return roller_mass_; }
  /// Centrifugal force of a roller [N] at the speed ω of the inner ring [rad/s]:
  ///
  ///   Fc = m d_m/2 ω_m²,   ω_m = ω (1 - D/d_m)/2
  ///
  /// m is the mass of the roller, and ω_m the orbital speed.
  [[nodiscard]] double centrifugal_force(double speed) const;
  /// Positions of the middle of each slice, measured from the middle of the roller along +x [m].
  [[nodiscard]] const std::array<double, lamina_count>& positions() const { return positions_; }
  /// Profile relief at the middle of each slice [m].
  [[nodiscard]] const std::array<double, lamina_count>& relief() const { return relief_; }
  /// Length of a slice [m].
  [[nodiscard]] double lamina_length() const {
    return geometry_.roller_length / static_cast<double>(lamina_count);
  }
  /// Azimuth of roller k, 2πk/Z from +y towards +z [rad], and its cosine and sine.
  struct Azimuth {
    double angle, cosine, sine;
  };
  [[nodiscard]] const std::vector<Azimuth>& azimuths() const { return azimuths_; }

 private:
  RollerGeometry geometry_;
  Material rollers_, rings_;
  LineContact contact_;
  double roller_mass_;
  std::array<double, lamina_count> positions_, relief_;
  std::vector<Azimuth> azimuths_;
};

}  // namespace raceway::bearing
