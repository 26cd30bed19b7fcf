#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bearing/geometry.h"

namespace raceway::files {

/// Published values of a mounted bearing pair, for one preload class (light, medium or strong).
struct PairPreload {
  double force = unset;           ///< [N]
  double axial_rigidity = unset;  ///< rigidity of the pair [N/m]
};

/// One row of a manufacturer's bearing catalogue. Empty cells are NaN.
struct CatalogueBearing {
  std::string maker;
  std::string designation;
  /// The static load rating C0 is for steel balls. Manufacturers do not publish groove radii, so
  /// the program assumes a conformity of 0.52 for both races.
  bearing::BearingGeometry geometry;
  double width = unset;                               ///< [m]
  double mass = unset;                                ///< [kg]
  double dynamic_load_rating = unset;                 ///< C [N]
  double static_load_rating_silicon_nitride = unset;  ///< C0 with Si3N4 balls [N]
  double speed_limit_oil = unset;                     ///< [rad/s]
  double speed_limit_grease = unset;                  ///< [rad/s]
  PairPreload light, medium, strong;
  /// Minimum spring preload at the speed limit, from the catalogue [N].
  double spring_preload_at_speed_limit = unset;

  /// Returns manufacturer and designation, such as "GMN S 6014 C TA".
  [[nodiscard]] std::string full_name() const { return maker + " " + designation; }
};

/// Returns the path of a data file or folder of raceway; empty if it is not found. The function
/// searches these folders in this order: share/raceway of the installation that contains this
/// program or library, the source tree, and the installation folder that was set at build time.
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

/// Returns the rows of all catalogues. The first rows come from the user's data folder
/// (own_data_directory()): from bearings/*.csv or, if this folder does not contain a folder named
/// bearings, from *.csv. The rows of bearings/*.csv in raceway's data folder follow. Throws
/// InputError if RACEWAY_DATA names a folder without a catalogue, or if no catalogue is found.
[[nodiscard]] std::vector<CatalogueBearing> read_catalogues();

/// Returns the rows whose name contains `filter`; all rows if `filter` is empty. Case, blanks and a
/// trailing "TA" (cage code) are ignored.
[[nodiscard]] std::vector<CatalogueBearing> matching_bearings(
    const std::vector<CatalogueBearing>& rows, std::string_view filter);

/// Returns the row with this name; null if there is none. Names are compared as in find_bearing().
[[nodiscard]] const CatalogueBearing* known_bearing(const std::vector<CatalogueBearing>& rows,
                                                    std::string_view name);

/// Returns the row with this name. Case, blanks, the manufacturer's name and a trailing "TA" (cage
/// code) are ignored. Throws InputError if no row matches; the message lists similar names.
[[nodiscard]] CatalogueBearing find_bearing(const std::vector<CatalogueBearing>& rows,
                                            std::string_view name);

}  // namespace raceway::files
