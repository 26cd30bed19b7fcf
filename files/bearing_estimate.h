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
  double width = unset;            ///< [m]; NaN where it is not known
  std::string dimension_series{};  ///< series of ISO 15, "10"; empty if unknown
  double contact_angle = unset;    ///< [rad]; by the designation, else 15 deg
  int ball_count = 0;              ///< 0: not known
  std::string ball_material = "steel";
};

/// A number estimated from ratios in the rows of a catalogue, with their least and largest values.
struct Estimate {
  double value = unset;
  double lower = unset, upper = unset;
};

struct EstimatedBearing {
  BearingOutline outline;                              ///< with data from its designation
  Estimate ball_diameter, pitch_diameter, conformity;  ///< [m], [m], [1]
  Estimate ball_count;                                 ///< as given, if it was given
  Estimate static_load_rating;                         ///< [N]
  std::size_t rows = 0;      ///< number of catalogue rows used for the ratios
  bool like_section = true;  ///< those rows have a similar section; else all rows
  bool like_series = true;   ///< a row has its dimension series
};

/// Returns angle and balls from the designation (files/designation.h), and bore, outer diameter and
/// width of its size from ISO 15 (files/boundary_dimensions.h); these are empty for other sizes.
/// Throws InputError for a bearing of another type.
[[nodiscard]] BearingOutline outline_of(std::string_view designation);

/// Estimates inner geometry from rows of similar section, or from all rows if those are few:
///
///   d_m = (d + D)/2,   D_w = k (D - d)/2,   Z = φ π d_m / D_w,   C0 = c Z D_w² cos α
///
/// with the median of k, φ and c, a known Z giving D_w = φ π d_m / Z; D_w is rounded to 1/32 inch,
/// the steps of ball sizes. Makers do not print conformities: 0.52, with 0.517 to 0.54, which make
/// the printed rigidities of GMN's pairs (raceway calibrate BEARING). Throws InputError where bore
/// or outer diameter is missing or they make no ring.
[[nodiscard]] EstimatedBearing estimated_bearing(const BearingOutline& outline,
                                                 const std::vector<CatalogueBearing>& rows);

/// Converts the estimates to a row of a catalogue.
[[nodiscard]] CatalogueBearing row_of(const EstimatedBearing& bearing);

/// Row of a bearing named by a designation.
struct NamedRow {
  CatalogueBearing row;
  bool is_estimated = false;   ///< not in a catalogue
  bool ceramic_balls = false;  ///< from its designation
  bool states_angle = true;    ///< false: 15 deg is assumed
};
/// Returns the row of the catalogue, else the estimate from its designation. Throws InputError as
/// find_bearing() for an unknown size, and as outline_of().
[[nodiscard]] NamedRow bearing_called(std::string_view name,
                                      const std::vector<CatalogueBearing>& rows);

/// Returns a commented model with the spread of every estimated key: one bearing on a rig, or three
/// in a spindle; `oil`: its ISO VG grade.
[[nodiscard]] std::string estimated_model_text(
    const EstimatedBearing& bearing, friction::FrictionLaw law = friction::FrictionLaw::palmgren,
    bool of_spindle = false, const std::string& oil = {});

}  // namespace raceway::files
