#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bearing/geometry.h"

namespace raceway::files {

/// Preload class of a mounted bearing pair (light, medium or strong), as published by the
/// manufacturer.
struct PairPreload {
  double force = unset;           ///< [N]
  double axial_rigidity = unset;  ///< rigidity of the pair [N/m]
};

/// One row of a manufacturer's bearing catalogue. Empty cells are NaN.
struct CatalogueBearing {
  std::string maker;
  std::string designation;
  /// The static load rating C0 is for steel balls. Manufacturers do not publish groove radii, so
  /// the conformities of both races are 0.52.
  bearing::BearingGeometry geometry;
  double width = unset;                               ///< [m]
  double mass = unset;                                ///< [kg]
  double dynamic_load_rating = unset;                 ///< C [N]
  double static_load_rating_silicon_nitride = unset;  ///< C0 with Si3N4 balls [N]
  double speed_limit_oil = unset;                     ///< [rad/s]
  double speed_limit_grease = unset;                  ///< [rad/s]
  PairPreload light, medium, strong;
  double spring_preload_at_speed_limit = unset;  ///< least spring preload at the speed limit [N]

  /// Returns manufacturer and designation, such as "GMN S 6014 C TA".
  [[nodiscard]] std::string full_name() const { return maker + " " + designation; }
};

/// Returns the path of a data file or folder of raceway; empty if it is not found. The function
/// searches share/raceway of the installation of this program or library, then the source tree,
/// then the installation folder set at build time.
[[nodiscard]] std::string data_file(const std::string& name);

/// Returns the path of raceway's data folder with the catalogues in bearings/; empty if it is not
/// found.
[[nodiscard]] std::string data_directory();

/// Returns the path of the user's data folder from the environment variable RACEWAY_DATA; empty if
/// the variable is not set. Throws InputError if the path is not a folder.
[[nodiscard]] std::string own_data_directory();

/// Reads one catalogue file. A line `# maker: NAME` names the manufacturer. Without this line, the
/// name is the file name up to the first underscore, in capitals. Throws InputError like
/// read_csv(), and for values outside the allowed ranges.
[[nodiscard]] std::vector<CatalogueBearing> read_catalogue(const std::string& path);

/// Parses a catalogue from its text.
[[nodiscard]] std::vector<CatalogueBearing> parse_catalogue(std::string text,
                                                            const std::string& path);

/// Returns the rows of all catalogues: first of the user's data folder (bearings/*.csv, or *.csv if
/// it has no folder bearings), then of bearings/*.csv in raceway's data folder. Throws InputError
/// if RACEWAY_DATA names a folder without a catalogue, or if no catalogue is found.
[[nodiscard]] std::vector<CatalogueBearing> read_catalogues();

/// Returns the rows whose name contains `filter`; all rows if `filter` is empty. Case, blanks and a
/// trailing "TA" are ignored.
[[nodiscard]] std::vector<CatalogueBearing> matching_bearings(
    const std::vector<CatalogueBearing>& rows, std::string_view filter);

/// Returns the row with this name, compared as in find_bearing(); null if there is none.
[[nodiscard]] const CatalogueBearing* known_bearing(const std::vector<CatalogueBearing>& rows,
                                                    std::string_view name);

/// Returns the row with this name. Case, blanks, the manufacturer's name and a trailing "TA" are
/// ignored. Throws InputError with similar names if there is no such row.
[[nodiscard]] CatalogueBearing find_bearing(const std::vector<CatalogueBearing>& rows,
                                            std::string_view name);

}  // namespace raceway::files
