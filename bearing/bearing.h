#pragma once

#include <vector>

#include "bearing/geometry.h"
#include "bearing/hertz.h"
#include "bearing/material.h"

namespace raceway::bearing {

/// Immutable ball bearing for the solvers: checked geometry, materials and derived constants. The
/// constructor computes the Hertz contacts, which takes time: construct one object, and use this
/// object for all operating points.
class Bearing {
 public:
  /// Throws std::invalid_argument in the same cases as validated(geometry) and validate(material).
  Bearing(const BearingGeometry& geometry, const Material& balls, const Material& rings);

  [[nodiscard]] const BearingGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const Material& balls() const { return balls_; }
  [[nodiscard]] const Material& rings() const { return rings_; }
  /// Contact of ball and race, with the curvature at the nominal contact angle. With the curvature
  /// at the contact angle in operation, the contact stiffness would differ by less than 0.2 %.
  [[nodiscard]] const HertzContact& contact(Race race) const {
    return race == Race::inner ? inner_ : outer_;
  }
  [[nodiscard]] double ball_mass() const { return ball_mass_; }  ///< m [kg]
  /// Moment of inertia of a ball about its centre, J = m D²/10 [kg m²].
  [[nodiscard]] double ball_inertia() const;
  /// Azimuth of ball k, 2πk/Z from +y towards +z [rad], and its cosine and sine.
  [[nodiscard]] const std::vector<double>& azimuth() const { return azimuth_; }
  [[nodiscard]] const std::vector<double>& cos_azimuth() const { return cos_azimuth_; }
  [[nodiscard]] const std::vector<double>& sin_azimuth() const { return sin_azimuth_; }

 private:
  BearingGeometry geometry_;
  Material balls_, rings_;
  HertzContact inner_, outer_;
  double ball_mass_;
  std::vector<double> azimuth_, cos_azimuth_, sin_azimuth_;
};

}  // namespace raceway::bearing
