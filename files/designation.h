#pragma once

#include <string>
#include <string_view>

#include "record/units.h"

namespace raceway::files {

/// Contents of a bearing's designation, by the systems of SKF, FAG, NSK, NTN and GMN.
///
/// Makers use the same letters for the same angles, with exceptions that are rows of the table in
/// designation.cpp: E is 25 deg behind "B7014-" of FAG and "S 6014 " of GMN, and a design of SKF
/// behind C or AC. Cage, seals and precision are passed over.
///
/// Source: SKF, Super-precision bearings, 13383; Schaeffler, Super Precision Bearings, SP 1; NSK,
/// Super Precision Bearings, E1254; NTN, Precision Rolling Bearings, 2260; GMN, High Precision Ball
/// Bearings, 4001. Prints not seen; the codes of angle, balls and preload of NSK, NTN and FAG were
/// compared with tables of dealers.
struct Designation {
  std::string series{};          ///< "70", "719"; of GMN "60", "619"
  std::string bore_code{};       ///< "14"
  double contact_angle = unset;  ///< [rad]; NaN where it is not stated
  std::string angle_code{};      ///< "AC"
  bool ceramic_balls = false;
  std::string ball_code{};    ///< "HC": what says so
  std::string preload{};      ///< "light", "medium", "heavy", "extra light"
  std::string arrangement{};  ///< "DB", "DF", "DT"
  std::string other_type{};   ///< "a cylindrical roller bearing": no angular contact

  /// "6014" of "B7014-C": what bearings of one size have in common; empty where it is not known.
  [[nodiscard]] std::string size() const;
};

/// Never throws: what is not known stays empty.
[[nodiscard]] Designation read_designation(std::string_view text);

/// Throws InputError for a bearing of another type, by name.
void require_angular_contact(std::string_view designation);

}  // namespace raceway::files
