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
  std::string dimension_series{};  ///< dimension series of ISO 15, such as "10"; empty if unknown
  double contact_angle = unset;    ///< [rad]; NaN: not known, so 15 deg is assumed
  int ball_count = 0;              ///< number of balls; 0: not known
  std::string ball_material = "steel";
};

/// An estimated value with lower and upper limits; see estimated_bearing().
struct Estimate {
  double value = unset;
  double lower = unset, upper = unset;
};

struct EstimatedBearing {
  BearingOutline outline;  ///< known properties; an unknown contact angle is set to 15 deg
  Estimate ball_diameter, pitch_diameter, conformity;  ///< [m], [m], [1]
  Estimate ball_count;          ///< number of balls; if known, both limits equal `value`
  Estimate static_load_rating;  ///< [N]
  std::size_t rows = 0;         ///< number of catalogue rows from which the estimate was made
  bool like_section = true;     ///< true: only rows with a similar section were used
  /// False if the dimension series is known and the catalogue contains no bearing of this series.
  bool like_series = true;
};

/// Returns the properties of a bearing that follow from its designation: contact angle and ball
/// material (files/designation.h), and bore, outer diameter and width
/// (files/boundary_dimensions.h). The contact angle is NaN if the designation does not state it.
/// The dimensions are NaN if boundary_dimensions() does not contain the size. Throws InputError for
/// a bearing without angular contact.
[[nodiscard]] BearingOutline outline_of(std::string_view designation);

/// Estimates the inner geometry of a bearing from catalogue rows with a similar section. The
/// sections of two bearings are similar if their ratios (D - d)/(D + d) differ by less than 0.025.
/// If there are fewer than eight such rows, all rows of angular-contact bearings are used.
///
///   d_m = (d + D)/2,   D_w = k (D - d)/2,   Z = φ π d_m / D_w,   C0 = c Z D_w² cos α
///
/// d is the bore, D the outer diameter, d_m the pitch diameter, D_w the ball diameter, Z the number
/// of balls, C0 the static load rating, and α the contact angle. The ratios k, φ and c are medians
/// over the catalogue rows, and their smallest and largest values give the limits of the estimates.
/// D_w is rounded to 1/32 inch, the step of ball sizes. If Z is known, D_w is φ π d_m / Z before it
/// is rounded. Manufacturers do not publish the conformity. It is estimated as 0.52, with limits of
/// 0.517 and 0.54. With a conformity in this range, the calculated rigidities of bearing pairs
/// agree with the rigidities that the maker GMN publishes.
///
/// Throws InputError if d or D is missing, if D is not between 1.1 d and 5 d, or if no catalogue
/// row has a contact angle.
[[nodiscard]] EstimatedBearing estimated_bearing(const BearingOutline& outline,
                                                 const std::vector<CatalogueBearing>& rows);

/// Converts an estimated bearing to a row of a catalogue.
[[nodiscard]] CatalogueBearing row_of(const EstimatedBearing& bearing);

/// Catalogue row or estimated row of a bearing with a given designation.
struct NamedRow {
  CatalogueBearing row;
  bool is_estimated = false;   ///< true: the bearing is in no catalogue
  bool ceramic_balls = false;  ///< true if the designation states ceramic balls
  bool states_angle = true;    ///< false: a contact angle of 15 deg is assumed
};
/// Returns the catalogue row with this name. If the catalogue does not contain the name, the
/// function estimates the bearing from the designation. Throws InputError if the designation gives
/// no known size, or names a bearing without angular contact.
[[nodiscard]] NamedRow bearing_called(std::string_view name,
                                      const std::vector<CatalogueBearing>& rows);

/// Returns the text of a model file for one estimated bearing on a rig or, if `of_spindle` is true,
/// for a spindle with three of these bearings. Comments give the limits of the estimated values.
/// `oil` is the ISO VG grade of the oil; if it is empty, the file describes a thin spindle oil.
[[nodiscard]] std::string estimated_model_text(
    const EstimatedBearing& bearing, friction::FrictionLaw law = friction::FrictionLaw::palmgren,
    bool of_spindle = false, const std::string& oil = {});

}  // namespace raceway::files
