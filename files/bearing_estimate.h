#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/catalogue_file.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// Known dimensions and properties of a bearing whose inner geometry is not published.
struct BearingOutline {
  std::string designation{};
  double bore = unset;             ///< [m]
  double outer_diameter = unset;   ///< [m]
  double width = unset;            ///< [m]; NaN: not known
  std::string dimension_series{};  ///< series of ISO 15, "10"; empty if unknown
  double contact_angle = unset;    ///< [rad]; NaN: not known, 15 deg is used
  int ball_count = 0;              ///< number of balls; 0: not known
  std::string ball_material = "steel";
};

/// An estimated value with lower and upper limits. The limits come from the smallest and the
/// largest ratio in the catalogue rows that were used; the limits of the conformity are fixed.
struct Estimate {
  double value = unset;
  double lower = unset, upper = unset;
};

struct EstimatedBearing {
  BearingOutline outline;  ///< known properties; an unknown contact angle is set to 15 deg
  Estimate ball_diameter, pitch_diameter, conformity;  ///< [m], [m], [1]
  Estimate ball_count;          ///< number of balls; if it is known, both limits equal it
  Estimate static_load_rating;  ///< [N]
  std::size_t rows = 0;         ///< number of catalogue rows used for the ratios
  bool like_section = true;     ///< true: only rows of bearings with similar section were used
  /// False: the dimension series is known, but no catalogue row belongs to it.
  bool like_series = true;
};

/// Returns the contact angle and the ball material that a designation states (files/designation.h),
/// and the bore, outer diameter and width of its size (files/boundary_dimensions.h). The angle is
/// NaN if the designation does not state it. The dimensions are NaN for a size outside the table.
/// Throws InputError for a bearing without angular contact.
[[nodiscard]] BearingOutline outline_of(std::string_view designation);

/// Estimates the inner geometry from catalogue rows of similar section, whose ratio (D - d)/(D + d)
/// differs from the ratio of this bearing by less than 0.025. If there are fewer than eight such
/// rows, all rows with a contact angle are used.
///
///   d_m = (d + D)/2,   D_w = k (D - d)/2,   Z = φ π d_m / D_w,   C0 = c Z D_w² cos α
///
/// d is the bore, D the outer diameter, d_m the pitch diameter, C0 the static load rating, and α
/// the contact angle. The ratios k, φ and c are medians over the catalogue rows. The ball diameter
/// D_w is rounded to 1/32 inch, the step of ball sizes. If the number of balls Z is known,
/// D_w = φ π d_m / Z before rounding. Manufacturers do not publish the conformity. The estimated
/// conformity is 0.52, with the range 0.517 to 0.54 that reproduces the published rigidities of
/// bearing pairs by GMN (`raceway calibrate BEARING`). Throws InputError if d or D is missing, if D
/// is not between 1.1 d and 5 d, or if no row has a contact angle.
[[nodiscard]] EstimatedBearing estimated_bearing(const BearingOutline& outline,
                                                 const std::vector<CatalogueBearing>& rows);

/// Converts the estimates to a row of a catalogue.
[[nodiscard]] CatalogueBearing row_of(const EstimatedBearing& bearing);

/// Catalogue row or estimated row of a bearing with a given designation.
struct NamedRow {
  CatalogueBearing row;
  bool is_estimated = false;   ///< true: the bearing is in no catalogue
  bool ceramic_balls = false;  ///< true if the designation states ceramic balls
  bool states_angle = true;    ///< false: the contact angle of 15 deg is assumed
};
/// Returns the catalogue row with this name. If there is none, returns an estimate from the
/// designation. Throws InputError if the size is unknown as well, or if the bearing has no angular
/// contact.
[[nodiscard]] NamedRow bearing_called(std::string_view name,
                                      const std::vector<CatalogueBearing>& rows);

/// Returns the text of a model file for one bearing on a rig, or for a spindle with three such
/// bearings. Comments give the limits of the estimated values. `oil` is the ISO VG grade of the
/// oil; if it is empty, the file describes a thin spindle oil.
[[nodiscard]] std::string estimated_model_text(
    const EstimatedBearing& bearing, friction::FrictionLaw law = friction::FrictionLaw::palmgren,
    bool of_spindle = false, const std::string& oil = {});

}  // namespace raceway::files
