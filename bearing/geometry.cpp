#include "bearing/geometry.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/validation.h"

namespace raceway::bearing {

double BearingGeometry::groove_centre_distance() const {
  return (inner_conformity + outer_conformity - 1.0) * ball_diameter;
}

double BearingGeometry::inner_groove_centre_radius() const {
  return pitch_diameter / 2.0 + (inner_conformity - 0.5) * ball_diameter * std::cos(contact_angle);
}

double BearingGeometry::outer_groove_centre_radius() const {
  return pitch_diameter / 2.0 - (outer_conformity - 0.5) * ball_diameter * std::cos(contact_angle);
}

double BearingGeometry::diameter_ratio() const { return ball_diameter / pitch_diameter; }

BearingGeometry validated(BearingGeometry g) {
  require_between("ball_count", g.ball_count == 0 ? unset : g.ball_count, 3, 200, 1.0, "");
  require_between("ball_diameter", g.ball_diameter, 0.1 * mm, 300 * mm, mm, "mm");
  require_between("pitch_diameter", g.pitch_diameter, 1 * mm, 5000 * mm, mm, "mm");
  require_between("contact_angle", g.contact_angle, 0.0, 65 * degree, degree, "deg");
  // At 0.5 the groove closes around the ball and the Hertz ellipse is unbounded.
  require_between("inner_conformity", g.inner_conformity, 0.5005, 0.7, 1.0, "");
  require_between("outer_conformity", g.outer_conformity, 0.5005, 0.7, 1.0, "");
  if (g.pitch_diameter <= g.ball_diameter * 1.2) {
    std::ostringstream text;
    text << "pitch_diameter = " << g.pitch_diameter / mm
         << " mm: must be above 1.2 times the ball diameter (" << 1.2 * g.ball_diameter / mm
         << " mm)";
    throw std::invalid_argument(text.str());
  }
  const double fitting = pi / std::asin(g.ball_diameter / g.pitch_diameter);
  if (g.ball_count > fitting) {
    std::ostringstream text;
    text << "ball_count = " << g.ball_count << ": at most " << std::floor(fitting) << " balls of "
         << g.ball_diameter / mm << " mm fit on a pitch circle of " << g.pitch_diameter / mm
         << " mm";
    throw std::invalid_argument(text.str());
  }
  if (g.contact_angle > 0.0 && g.radial_clearance != 0.0) {
    std::ostringstream text;
    text << "radial_clearance = " << g.radial_clearance / um
         << " um: only possible with contact_angle = 0; the clearance of an angular-contact "
            "bearing follows from its contact angle";
    throw std::invalid_argument(text.str());
  }
  require_between("radial_clearance", g.radial_clearance, 0.0, g.groove_centre_distance(), um,
                  "um");
  if (std::isnan(g.bore)) g.bore = g.pitch_diameter - 1.5 * g.ball_diameter;
  if (std::isnan(g.outer_diameter)) g.outer_diameter = g.pitch_diameter + 1.5 * g.ball_diameter;
  require_between("bore", g.bore, 0.0, g.pitch_diameter - g.ball_diameter, mm, "mm");
  require_between("outer_diameter", g.outer_diameter, g.pitch_diameter + g.ball_diameter,
                  2.0 * g.pitch_diameter + 2.0 * g.ball_diameter, mm, "mm");
  // From the bottom of the groove to the pitch circle.
  if (!std::isnan(g.inner_shoulder_diameter))
    require_between("inner_shoulder_diameter", g.inner_shoulder_diameter,
                    2.0 * (g.inner_groove_centre_radius() - g.inner_conformity * g.ball_diameter),
                    g.pitch_diameter, mm, "mm");
  if (!std::isnan(g.outer_shoulder_diameter))
    require_between("outer_shoulder_diameter", g.outer_shoulder_diameter, g.pitch_diameter,
                    2.0 * (g.outer_groove_centre_radius() + g.outer_conformity * g.ball_diameter),
                    mm, "mm");
  if (!std::isnan(g.static_load_rating))
    require_between("static_load_rating", g.static_load_rating, 1.0, 1e9, 1.0, "N");
  return g;
}

}  // namespace raceway::bearing
