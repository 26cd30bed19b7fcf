#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "files/boundary_dimensions.h"
#include "record/units.h"

namespace raceway::files {

/// Properties that the designation of a bearing states, in the systems of SKF, SNFA, FAG, Barden,
/// NSK, NTN and GMN.
///
/// Most designations contain the digits of the ISO system, such as 7014. SNFA (VEX 70), the
/// high-speed series of NTN (HSE014), Barden (114HC) and the robust series of NSK (70BNR10) use
/// other forms. The letters for the contact angle are the same for most manufacturers. An exception
/// is the letter E: in "B7014-E" of FAG and "S 6014 E" of GMN, the letter means 25 deg; after C or
/// AC in designations of SKF, the letter means a design variant. Codes of cage, seals and precision
/// are ignored.
///
/// Source: SKF, Super-precision bearings, 13383, and for the series of SNFA 06939 (HB, HX) and
/// 06981 (E 200); Schaeffler, Super Precision Bearings, SP 1; Barden, MRO Catalog C8A, p. 4; NSK,
/// Super Precision Bearings, E1254; NTN, Precision Rolling Bearings, 2260, p. 56, and ULTAGE, 7000
/// and 7900; GMN, High Precision Ball Bearings, 4001. Only the given pages of Barden and NTN were
/// read, in text copies. The other publications were not available. The codes for contact angle,
/// balls and preload of NSK, NTN and FAG were compared with tables of dealers. The digits for the
/// contact angle in SNFA designations were not checked.
struct Designation {
  /// Series as written, such as "70", "719" or "VEX"; for GMN "60" or "619".
  std::string series{};
  std::string dimensions{};      ///< dimension series of ISO 15: "10", "19"; empty if unknown
  std::string bore_code{};       ///< bore code: "14"
  double contact_angle = unset;  ///< contact angle [rad]; NaN if not stated
  std::string angle_code{};      ///< code of the contact angle: "AC"
  bool ceramic_balls = false;
  std::string ball_code{};    ///< code of ceramic balls: "HC"
  std::string preload{};      ///< preload class: "light", "medium", "heavy" or "extra light"
  std::string arrangement{};  ///< back to back "DB", face to face "DF" or tandem "DT"
  /// Type of a bearing without angular contact: "a cylindrical roller bearing".
  std::string other_type{};

  /// Returns the size of the bearing as the designation of a deep groove ball bearing with the same
  /// boundary dimensions: "6014" for "B7014-C". The result is empty if the size is not known.
  [[nodiscard]] std::string size() const;
  /// Returns the boundary dimensions of this bearing size in ISO 15; empty if the size is unknown.
  [[nodiscard]] std::optional<BoundaryDimensions> boundary() const;
};

/// Parses a designation. A property that the designation does not state is empty or NaN. The
/// function never throws.
[[nodiscard]] Designation read_designation(std::string_view text);

/// Throws InputError if the designation names a bearing without angular contact.
void require_angular_contact(std::string_view designation);

}  // namespace raceway::files
