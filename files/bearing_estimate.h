#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/catalogue_file.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// Known data of a bearing whose inner geometry is not published.
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

/// A number made of ratios that the rows of a catalogue have, with the least and the largest of
/// them.
struct Estimate {
  double value = unset;
  double lower = unset, upper = unset;
};

struct EstimatedBearing {
  BearingOutline outline;                              ///< with what its designation says
  Estimate ball_diameter, pitch_diameter, conformity;  ///< [m], [m], [1]
  Estimate ball_count;                                 ///< as given where it was
  Estimate static_load_rating;                         ///< [N]
  std::size_t rows = 0;      ///< number of catalogue rows used for the ratios
  bool like_section = true;  ///< those rows have a similar section; else all rows
  bool like_series = true;   ///< a row has its dimension series
};

/// Angle and balls by the designation (files/designation.h); bore, outer diameter and width of its
/// size by ISO 15 (files/boundary_dimensions.h), nothing for another one. Throws InputError for a
/// bearing of another type.
[[nodiscard]] BearingOutline outline_of(std::string_view designation);

/// Estimates inner geometry from rows of similar section, or from all rows if those are few:
///
///   d_m = (d + D)/2,   D_w = k (D - d)/2,   Z = φ π d_m / D_w,   C0 = c Z D_w² cos α
///
/// with the median of k, φ and c, a known Z giving D_w = φ π d_m / Z; D_w is rounded to 1/32 inch,
/// as balls come. No maker prints conformities: 0.52, with 0.517 to 0.54, which make the printed
/// rigidities of GMN's pairs (raceway calibrate BEARING).
/// Throws InputError where bore or outer diameter is missing or they make no ring.
[[nodiscard]] EstimatedBearing estimated_bearing(const BearingOutline& outline,
                                                 const std::vector<CatalogueBearing>& rows);

/// The estimates as a row of a catalogue.
[[nodiscard]] CatalogueBearing row_of(const EstimatedBearing& bearing);

/// Row of a bearing that a designation names.
struct NamedRow {
  CatalogueBearing row;
  bool is_estimated = false;   ///< in no catalogue
  bool ceramic_balls = false;  ///< by its designation
  bool states_angle = true;    ///< false: 15 deg is assumed
};
/// The row of the catalogue, else the estimate by its designation. Throws InputError as
/// find_bearing() for a size that is not known, and as outline_of().
[[nodiscard]] NamedRow bearing_called(std::string_view name,
                                      const std::vector<CatalogueBearing>& rows);

/// A commented model of it, every estimated key marked with its spread: on a rig, or three of it in
/// a spindle; `oil`: its ISO VG grade.
[[nodiscard]] std::string estimated_model_text(
    const EstimatedBearing& bearing, friction::FrictionLaw law = friction::FrictionLaw::palmgren,
    bool of_spindle = false, const std::string& oil = {});

}  // namespace raceway::files
