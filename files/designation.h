#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "files/boundary_dimensions.h"
#include "record/units.h"

namespace raceway::files {

/// Data in a bearing's designation, in the systems of SKF, SNFA, FAG, Barden, NSK, NTN and GMN.
///
/// Most names have the digits of ISO's system, 7014. Those of SNFA (VEX 70), NTN's fast series
/// (HSE014), Barden (114HC) and NSK's robust series (70BNR10) have forms of their own. Makers use
/// the same letters for the same angles, with exceptions that are rows of the table in
/// designation.cpp: E is 25 deg behind "B7014-" of FAG and "S 6014 " of GMN, and a design of SKF
/// behind C or AC. Cage, seals and precision are ignored.
///
/// Source: SKF, Super-precision bearings, 13383, and for the series of SNFA 06939 (HB, HX) and
/// 06981 (E 200); Schaeffler, Super Precision Bearings, SP 1; Barden, MRO Catalog C8A, p. 4; NSK,
/// Super Precision Bearings, E1254; NTN, Precision Rolling Bearings, 2260, p. 56, and ULTAGE, 7000
/// and 7900; GMN, High Precision Ball Bearings, 4001. Read in copies of their text: Barden's page,
/// NTN's pages, titles of SKF. Not seen: the other prints; the codes of angle, balls and preload of
/// NSK, NTN and FAG were compared with tables of dealers, the digits of angles of SNFA with
/// nothing.
struct Designation {
  std::string series{};          ///< as written: "70", "719", "VEX", GMN "60", "619"
  std::string dimensions{};      ///< dimension series of ISO 15: "10", "19"; empty where unknown
  std::string bore_code{};       ///< "14"
  double contact_angle = unset;  ///< [rad]; NaN if not stated
  std::string angle_code{};      ///< "AC"
  bool ceramic_balls = false;
  std::string ball_code{};    ///< "HC": what says so
  std::string preload{};      ///< "light", "medium", "heavy", "extra light"
  std::string arrangement{};  ///< "DB", "DF", "DT"
  std::string other_type{};   ///< "a cylindrical roller bearing": no angular contact

  /// Size of a bearing: "6014" for "B7014-C"; empty if not known.
  [[nodiscard]] std::string size() const;
  /// Boundary dimensions of that size by ISO 15.
  [[nodiscard]] std::optional<BoundaryDimensions> boundary() const;
};

/// Parses a designation. Never throws: unknown data stay empty.
[[nodiscard]] Designation read_designation(std::string_view text);

/// Throws InputError for a bearing of another type, by name.
void require_angular_contact(std::string_view designation);

}  // namespace raceway::files
