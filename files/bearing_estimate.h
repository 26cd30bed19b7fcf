#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/catalogue_file.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// Known data of a bearing with unpublished inner geometry.
struct BearingOutline {
  std::string designation{};
  double bore = unset;             ///< [m]
  double outer_diameter = unset;   ///< [m]
  double width = unset;            ///< [m]; NaN if not known
  std::string dimension_series{};  ///< series of ISO 15, "10"; empty if unknown
  double contact_angle = unset;    ///< [rad]; NaN: not known, 15 deg are used
  int ball_count = 0;              ///< 0: not known
  std::string ball_material = "steel";
};

/// An estimated number with its lower and upper value. The limits come from the spread of ratios in
/// the rows of a catalogue.
struct Estimate {
  double value = unset;
  double lower = unset, upper = unset;
};

struct EstimatedBearing {
  BearingOutline outline;  ///< as given; an unknown contact angle is set to 15 deg
  Estimate ball_diameter, pitch_diameter, conformity;  ///< [m], [m], [1]
  Estimate ball_count;                                 ///< the given count, if there is one
  Estimate static_load_rating;                         ///< [N]
  std::size_t rows = 0;      ///< number of catalogue rows used for the ratios
  bool like_section = true;  ///< true: from rows of similar section; false: from all rows
  bool like_series = true;   ///< false: no row has the dimension series of this bearing
};

/// Returns the contact angle and the ball material from the designation (files/designation.h), and
/// bore, outer diameter and width from ISO 15 (files/boundary_dimensions.h). The angle is NaN if
/// the designation does not state it, and the dimensions are NaN for a size outside that table.
/// Throws InputError for a bearing without angular contact.
[[nodiscard]] BearingOutline outline_of(std::string_view designation);

/// Estimates the inner geometry from catalogue rows of similar section. If there are fewer than
/// eight such rows, the function uses all rows with a contact angle.
///
///   d_m = (d + D)/2,   D_w = k (D - d)/2,   Z = φ π d_m / D_w,   C0 = c Z D_w² cos α
///
/// k, φ and c are medians. If Z is known, D_w = φ π d_m / Z. D_w is rounded to 1/32 inch, the step
/// of ball sizes. Manufacturers do not print the conformity. The estimate is 0.52, with the range
/// 0.517 to 0.54 that reproduces the printed rigidities of GMN's pairs (raceway calibrate BEARING).
/// Throws InputError if bore or outer diameter is missing or if they do not form a ring.
[[nodiscard]] EstimatedBearing estimated_bearing(const BearingOutline& outline,
                                                 const std::vector<CatalogueBearing>& rows);

/// Converts the estimates to a row of a catalogue.
[[nodiscard]] CatalogueBearing row_of(const EstimatedBearing& bearing);

/// Catalogue row or estimated row of a bearing with a given designation.
struct NamedRow {
  CatalogueBearing row;
  bool is_estimated = false;   ///< true: the bearing is in no catalogue
  bool ceramic_balls = false;  ///< true if the designation states ceramic balls
  bool states_angle = true;    ///< false: 15 deg is assumed
};
/// Returns the row of the catalogue, or an estimate from the designation if the catalogue does not
/// have the bearing. Throws InputError like find_bearing() for an unknown size, and like
/// outline_of().
[[nodiscard]] NamedRow bearing_called(std::string_view name,
                                      const std::vector<CatalogueBearing>& rows);

/// Returns a commented model with the spread of every estimated key. The model describes one
/// bearing on a rig, or a spindle with three such bearings. `oil` is the ISO VG grade of the oil.
[[nodiscard]] std::string estimated_model_text(
    const EstimatedBearing& bearing, friction::FrictionLaw law = friction::FrictionLaw::palmgren,
    bool of_spindle = false, const std::string& oil = {});

}  // namespace raceway::files
