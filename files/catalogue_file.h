#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bearing/geometry.h"

namespace raceway::files {

/// Light, medium or strong preload of a mounted pair as the maker prints it.
struct PairPreload {
  double force = unset;           ///< [N]
  double axial_rigidity = unset;  ///< rigidity of the pair [N/m]
};

/// One row of a maker's catalogue of bearings. Blank values are NaN.
struct CatalogueBearing {
  std::string maker;
  std::string designation;
  /// C0 is for steel balls. Makers print no groove radii, so both conformities are the default
  /// 0.52.
  bearing::BearingGeometry geometry;
  double width = unset;                               ///< [m]
  double mass = unset;                                ///< [kg]
  double dynamic_load_rating = unset;                 ///< C [N]
  double static_load_rating_silicon_nitride = unset;  ///< C0 with Si3N4 balls [N]
  double speed_limit_oil = unset;                     ///< [rad/s]
  double speed_limit_grease = unset;                  ///< [rad/s]
  PairPreload light, medium, strong;
  double spring_preload_at_speed_limit = unset;  ///< least spring preload at that limit [N]

  /// "GMN S 6014 C TA".
  [[nodiscard]] std::string full_name() const { return maker + " " + designation; }
};

/// Path of a file or folder in the data of the program or the shared library: in share/raceway next
/// to it, else in its source tree, else in the installation folder; empty if not found.
[[nodiscard]] std::string data_file(const std::string& name);

/// Folder of the catalogues, bearings/, in these data; empty if not found.
[[nodiscard]] std::string data_directory();

/// The user's data folder: the environment variable RACEWAY_DATA, empty if not set. Throws
/// InputError if it is not a folder.
[[nodiscard]] std::string own_data_directory();

/// Reads one file of a catalogue. The maker is named in a line `# maker: NAME`, else by the file's
/// name up to its first underscore. Throws InputError as read_csv(), and for impossible values.
[[nodiscard]] std::vector<CatalogueBearing> read_catalogue(const std::string& path);

/// Parses a catalogue from its text.
[[nodiscard]] std::vector<CatalogueBearing> parse_catalogue(std::string text,
                                                            const std::string& path);

/// Returns the rows of the user's folder (its bearings/*.csv, else its *.csv), then all rows of
/// bearings/*.csv in the data directory, file by file. Throws InputError if neither has any.
[[nodiscard]] std::vector<CatalogueBearing> read_catalogues();

/// Rows whose name contains `filter` (case, blanks and a trailing "TA" do not matter); all if
/// empty.
[[nodiscard]] std::vector<CatalogueBearing> matching_bearings(
    const std::vector<CatalogueBearing>& rows, std::string_view filter);

/// Returns the row with this name; null if there is none.
[[nodiscard]] const CatalogueBearing* known_bearing(const std::vector<CatalogueBearing>& rows,
                                                    std::string_view name);

/// The row of that name; case, blanks, the maker's name and a trailing "TA" do not matter.
/// Throws InputError with the nearest names for an unknown one.
[[nodiscard]] CatalogueBearing find_bearing(const std::vector<CatalogueBearing>& rows,
                                            std::string_view name);

}  // namespace raceway::files
