#pragma once

#include <string>

#include "record/units.h"

namespace raceway::bearing {

/// Internal geometry of a ball bearing with two grooves of circular section.
struct BearingGeometry {
  int ball_count = 0;             ///< Z [1]
  double ball_diameter = unset;   ///< D [m]
  double pitch_diameter = unset;  ///< d_m [m]
  double contact_angle = unset;   ///< nominal contact angle α0 without load [rad]; 0: deep groove
  double inner_conformity = unset;  ///< f_i = groove radius / D [1], > 0.5
  double outer_conformity = unset;  ///< f_o = groove radius / D [1], > 0.5
  double radial_clearance = 0.0;  ///< diametral play [m], only for a deep-groove bearing (α0 = 0)
  double bore = unset;            ///< bore diameter d [m], default d_m - 1.5 D
  double outer_diameter = unset;  ///< outer diameter of the outer ring [m], default d_m + 1.5 D
  double static_load_rating = unset;  ///< static load rating C0 [N]; some friction laws need it
  /// Diameters of the ring shoulders next to the grooves, if known [m]; see shoulder.h.
  double inner_shoulder_diameter = unset, outer_shoulder_diameter = unset;

  /// Distance between the two groove centres without load, B D = (f_i + f_o - 1) D [m].
  [[nodiscard]] double groove_centre_distance() const;
  /// Radius of the circle of inner groove centres, R_i = d_m/2 + (f_i - 0.5) D cos α0 [m]. This
  /// radius is the lever arm of tilt and moment. ISO/TS 16281 has the same formula; some programs
  /// use d_m/2 instead.
  [[nodiscard]] double inner_groove_centre_radius() const;
  /// Radius of the circle of outer groove centres, R_o = d_m/2 - (f_o - 0.5) D cos α0 [m].
  [[nodiscard]] double outer_groove_centre_radius() const;
  /// Ratio of ball diameter to pitch diameter, γ' = D / d_m [1].
  [[nodiscard]] double diameter_ratio() const;
};

/// Returns the geometry with default values for missing optional dimensions. Throws
/// std::invalid_argument for the first missing or impossible value. The message gives name, value
/// and allowed range.
[[nodiscard]] BearingGeometry validated(BearingGeometry geometry);

}  // namespace raceway::bearing
