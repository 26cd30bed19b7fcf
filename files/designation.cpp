#include "files/designation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "text/csv.h"
#include "text/error.h"

namespace raceway::files {
namespace {

/// Capital letters and digits; what separates parts stands as one '-' or '/'.
std::string in_capitals(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '.' || c == '_') continue;
    result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  for (const std::string_view maker : {"SKF", "SNFA", "FAG", "BARDEN", "NSK", "NTN", "GMN"})
    if (result.size() > maker.size() && result.starts_with(maker)) result.erase(0, maker.size());
  return result;
}

struct AngleCode {
  std::string_view makers;
  std::string_view code;  ///< behind the bore, longest first
  double angle_deg;
};
/// CE, CB, CD and ACE, ACB, ACD are designs of SKF at the angle of C and AC.
constexpr std::array angle_codes{
    AngleCode{"SKF", "AC", 25.0},         AngleCode{"NTN", "AD", 25.0},
    AngleCode{"NSK", "A5", 25.0},         AngleCode{"all", "C", 15.0},
    AngleCode{"SKF", "F", 18.0},          AngleCode{"FAG, GMN", "E", 25.0},
    AngleCode{"FAG", "D", 20.0},          AngleCode{"NSK, NTN", "A", 30.0},
    AngleCode{"all, standard", "B", 40.0}};
/// NSK's robust series have the angle in the letters behind the bore and the series.
constexpr std::array robust_codes{AngleCode{"NSK", "BNR", 18.0}, AngleCode{"NSK", "BER", 25.0},
                                  AngleCode{"NSK", "BGR", 15.0}};

struct Prefix {
  std::string_view makers;
  std::string_view code;
  bool ceramic_balls;
};
/// Longest first: HCB and XCB of FAG are hybrids of the B design, HCS and XCS of HS.
constexpr std::array prefixes{
    Prefix{"FAG", "HCRS", true}, Prefix{"FAG", "XCRS", true},   Prefix{"FAG", "HCB", true},
    Prefix{"FAG", "XCB", true},  Prefix{"FAG", "HCS", true},    Prefix{"FAG", "XCS", true},
    Prefix{"FAG", "HC", true},   Prefix{"FAG", "XC", true},     Prefix{"FAG", "RS", false},
    Prefix{"FAG", "HSS", false}, Prefix{"FAG", "HS", false},    Prefix{"FAG", "B", false},
    Prefix{"ZYS", "H", false},   Prefix{"GMN", "HYKH", true},   Prefix{"GMN", "HYSM", true},
    Prefix{"GMN", "HYS", true},  Prefix{"GMN", "KHS", false},   Prefix{"GMN", "KH", false},
    Prefix{"GMN", "SM", false},  Prefix{"SKF, GMN", "S", false}};
/// In front of all of NTN's names, 5S before 2LA.
constexpr std::array ntn_prefixes{Prefix{"NTN", "5S", true}, Prefix{"NTN", "2LA", false}};

/// Dimension series of ISO 15 by the digits in front of the bore code.
struct DigitSeries {
  std::string_view digits, dimensions;
};
constexpr std::array digit_series{
    DigitSeries{"70", "10"}, DigitSeries{"60", "10"},  DigitSeries{"719", "19"},
    DigitSeries{"79", "19"}, DigitSeries{"619", "19"}, DigitSeries{"718", "18"},
    DigitSeries{"78", "18"}, DigitSeries{"618", "18"}, DigitSeries{"72", "02"},
    DigitSeries{"62", "02"}, DigitSeries{"73", "03"},  DigitSeries{"63", "03"}};

/// SNFA: the bore in millimetres behind the series, the angle as the last digit, "VEX 70 /NS 7CE1".
constexpr std::array snfa_series{DigitSeries{"SEA", "18"}, DigitSeries{"SEB", "19"},
                                 DigitSeries{"VEB", "19"}, DigitSeries{"HB", "19"},
                                 DigitSeries{"VEX", "10"}, DigitSeries{"EX", "10"},
                                 DigitSeries{"HX", "10"},  DigitSeries{"E2", "02"}};
constexpr std::array snfa_angles{AngleCode{"SNFA", "1", 15.0}, AngleCode{"SNFA", "2", 18.0},
                                 AngleCode{"SNFA", "3", 25.0}};

/// NTN: the diameter series as a digit and the bore code behind the series, "HSE014C".
struct NtnSeries {
  std::string_view code;
  double angle_deg;  ///< of a name without an angle; NaN where it is not known
};
constexpr std::array ntn_series{NtnSeries{"HSFL", unset}, NtnSeries{"HSF", unset},
                                NtnSeries{"HSE", 20.0},   NtnSeries{"HSL", 20.0},
                                NtnSeries{"BNS", 20.0},   NtnSeries{"BNT", unset}};
constexpr std::array ntn_angles{AngleCode{"NTN", "C", 15.0}, AngleCode{"NTN", "AD", 25.0},
                                AngleCode{"NTN", "D", 25.0}};

/// Barden: "114HC" has diameter series 1 and bore code 14, "1914HC" series 19; C in front is
/// ceramic balls, ZSB small ones.
constexpr std::array barden_series{DigitSeries{"19", "19"}, DigitSeries{"1", "10"},
                                   DigitSeries{"2", "02"}, DigitSeries{"3", "03"}};

struct OtherType {
  std::string_view code;  ///< in front of the digits
  std::string_view words;
};
constexpr std::string_view of_screws = "an angular-contact thrust ball bearing for screw drives",
                           of_thrust = "an angular-contact thrust ball bearing";
constexpr std::array other_types{OtherType{"NNU", "a double-row cylindrical roller bearing"},
                                 OtherType{"NN", "a double-row cylindrical roller bearing"},
                                 OtherType{"NUP", "a cylindrical roller bearing"},
                                 OtherType{"NU", "a cylindrical roller bearing"},
                                 OtherType{"NJ", "a cylindrical roller bearing"},
                                 OtherType{"NF", "a cylindrical roller bearing"},
                                 OtherType{"HCN", "a cylindrical roller bearing"},
                                 OtherType{"NA", "a needle roller bearing"},
                                 OtherType{"NK", "a needle roller bearing"},
                                 OtherType{"RNA", "a needle roller bearing"},
                                 OtherType{"BSA", of_screws},
                                 OtherType{"BSD", of_screws},
                                 OtherType{"BSB", of_screws},
                                 OtherType{"BST", of_screws},
                                 OtherType{"BS", of_screws},
                                 OtherType{"ZKLN", of_screws},
                                 OtherType{"ZKLF", of_screws},
                                 OtherType{"ZARN", "a needle roller bearing with thrust rollers"},
                                 OtherType{"ZARF", "a needle roller bearing with thrust rollers"},
                                 OtherType{"BTW", of_thrust},
                                 OtherType{"BTM", of_thrust},
                                 OtherType{"HTA", of_thrust},
                                 OtherType{"QJ", "a four-point contact ball bearing"},
                                 OtherType{"HR", "a tapered roller bearing"},
                                 OtherType{"4T-", "a tapered roller bearing"},
                                 OtherType{"N", "a cylindrical roller bearing"}};

/// By the digits of ISO's system, where no letter in front says more.
std::string_view type_of_digits(std::string_view digits) {
  if (digits.starts_with("234") && digits.size() == 6)
    return "a double-direction angular-contact thrust ball bearing";
  if (digits.size() == 7 && digits.starts_with("760")) return of_screws;
  if (digits.size() == 5 && digits.starts_with("16")) return "a deep groove ball bearing";
  if (digits.size() == 5 && digits.starts_with("29")) return "a spherical roller thrust bearing";
  if (digits.size() == 5 && digits.starts_with("8")) return "a cylindrical roller thrust bearing";
  if (digits.size() == 5 && digits.starts_with("3")) return "a tapered roller bearing";
  if (digits.size() == 5 && digits.starts_with("2")) return "a spherical roller bearing";
  if (digits.size() == 5 && digits.starts_with("5")) return "a thrust ball bearing";
  if (digits.size() == 4 && (digits.starts_with("12") || digits.starts_with("13") ||
                             digits.starts_with("22") || digits.starts_with("23")))
    return "a self-aligning ball bearing";
  if (digits.size() == 4 && (digits.starts_with("32") || digits.starts_with("33")))
    return "a double-row angular-contact ball bearing";
  if ((digits.size() == 4 || digits.size() == 5) && digits.starts_with("6"))
    return "a deep groove ball bearing";
  return {};
}

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// The prefix that the text begins with, where a digit stands behind it.
const Prefix* prefix_of(std::string_view text) {
  for (const Prefix& p : prefixes)
    if (text.starts_with(p.code) && text.size() > p.code.size() &&
        is_decimal_digit(text[p.code.size()]))
      return &p;
  return nullptr;
}

const OtherType* other_type_of(std::string_view text) {
  for (const OtherType& t : other_types)
    if (text.starts_with(t.code) && text.size() > t.code.size() &&
        is_decimal_digit(text[t.code.size()]))
      return &t;
  return nullptr;
}

/// Balls, preload and arrangement, wherever they stand behind the angle.
void read_suffixes(std::string_view rest, Designation& d) {
  const auto has = [&](std::string_view code) { return rest.find(code) != rest.npos; };
  for (const std::string_view code : {"/HC", "SN24", "HYBRID", "/NS", "NS7", "NS9"})
    if (d.ball_code.empty() && has(code)) {
      d.ceramic_balls = true;
      d.ball_code = code.starts_with('/') ? code.substr(1) : code;
    }
  struct Preload {
    std::string_view code, words;
  };
  // SKF and NSK have the preload behind the arrangement: DBA, DBEL.
  constexpr std::array behind_arrangement{
      Preload{"C2", "extra light"}, Preload{"C7", "light"},       Preload{"C8", "medium"},
      Preload{"C9", "heavy"},       Preload{"EL", "extra light"}, Preload{"L", "light"},
      Preload{"M", "medium"},       Preload{"H", "heavy"},        Preload{"A", "light"},
      Preload{"B", "medium"},       Preload{"C", "heavy"}};
  for (const std::string_view code : {"DB", "DF", "DT", "SU", "DU"}) {
    const std::size_t at = rest.find(code);
    if (at == rest.npos) continue;
    if (d.arrangement.empty() && !code.ends_with('U')) d.arrangement = code;
    const std::string_view behind = rest.substr(at + code.size());
    for (const Preload& p : behind_arrangement)
      if (d.preload.empty() && behind.starts_with(p.code)) d.preload = p.words;
  }
  constexpr std::array preloads{
      Preload{"UL", "light"},       Preload{"UM", "medium"},     Preload{"UH", "heavy"},
      Preload{"GA", "light"},       Preload{"GB", "medium"},     Preload{"GC", "heavy"},
      Preload{"GL", "extra light"}, Preload{"GN", "light"},      Preload{"GM", "medium"},
      Preload{"GH", "heavy"},       Preload{"EL", "extra light"}};
  for (const Preload& p : preloads)
    if (d.preload.empty() && has(p.code)) d.preload = p.words;
}

/// The digits at the beginning as a number; nothing for none and for more than four.
std::optional<int> leading_number(std::string_view text) {
  int value = 0;
  std::size_t size = 0;
  for (; size < text.size() && is_decimal_digit(text[size]); ++size)
    if (size < 4) value = 10 * value + (text[size] - '0');
  return size == 0 || size > 4 ? std::nullopt : std::optional(value);
}

template <typename Codes>
void read_angle(std::string_view code, const Codes& codes, Designation& d) {
  for (const AngleCode& one : codes)
    if (code.starts_with(one.code)) {
      d.contact_angle = one.angle_deg * degree;
      d.angle_code = one.code;
      return;
    }
}

/// 70BNR10H: bore, series, material.
bool read_robust(std::string_view text, Designation& d) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto bore = leading_number(text);
  for (const AngleCode& code : robust_codes) {
    if (!bore || !text.substr(digits).starts_with(code.code)) continue;
    const std::string_view behind = text.substr(digits + code.code.size());
    if (!behind.starts_with("10") && !behind.starts_with("19")) continue;
    d.series = code.code;
    d.dimensions = behind.substr(0, 2);
    d.bore_code = bore_code_of(*bore);
    d.contact_angle = code.angle_deg * degree;
    d.angle_code = code.code;
    const std::string_view material = behind.substr(2);
    d.ceramic_balls = material.starts_with('H') || material.starts_with('X');
    if (d.ceramic_balls) d.ball_code = material.substr(0, 1);
    read_suffixes(material, d);
    return true;
  }
  return false;
}

/// VEX 70 /S/NS 7CE1 DDL
bool read_snfa(std::string_view text, Designation& d) {
  for (const DigitSeries& series : snfa_series) {
    if (!text.starts_with(series.digits)) continue;
    const std::string_view behind = text.substr(series.digits.size());
    // Precision may follow at once: "VEX707CE1" has the bore 70.
    for (std::size_t size = 3; size >= 2; --size) {
      const std::string_view digits = behind.substr(0, size);
      if (digits.size() < size || digits.find_first_not_of("0123456789") != digits.npos) continue;
      const std::string_view code = bore_code_of(leading_number(digits).value_or(0));
      if (!boundary_dimensions(series.dimensions, code)) continue;
      d.series = series.digits;
      d.dimensions = series.dimensions;
      d.bore_code = code;
      std::string_view rest = behind.substr(size);
      read_suffixes(rest, d);
      // Precision, cage, angle: 7CE1.
      const std::size_t precision = rest.find_first_of("0123456789");
      if (precision != rest.npos) rest.remove_prefix(precision + 1);
      const std::size_t angle = rest.find_first_of("0123456789");
      if (precision != rest.npos && angle != rest.npos && angle > 0)
        read_angle(rest.substr(angle), snfa_angles, d);
      return true;
    }
  }
  return false;
}

/// 5S-2LA-HSE014C, without what stands in front of HSE.
bool read_ntn(std::string_view text, Designation& d) {
  for (const NtnSeries& series : ntn_series) {
    if (!text.starts_with(series.code)) continue;
    const std::string_view behind = text.substr(series.code.size());
    if (behind.size() < 3 || behind.substr(0, 3).find_first_not_of("0123456789") != behind.npos)
      continue;
    d.dimensions = behind[0] == '9' ? "19" : behind[0] == '0' ? "10" : behind[0] == '2' ? "02" : "";
    if (d.dimensions.empty()) continue;
    d.series = std::string(series.code) + behind[0];
    d.bore_code = behind.substr(1, 2);
    std::string_view rest = behind.substr(3);
    if (rest.starts_with('U')) rest.remove_prefix(1);
    // DB, DF and DT are arrangements.
    const bool pair = rest.starts_with("DB") || rest.starts_with("DF") || rest.starts_with("DT");
    if (!pair) read_angle(rest, ntn_angles, d);
    if (d.angle_code.empty() && !std::isnan(series.angle_deg)) {
      d.contact_angle = series.angle_deg * degree;
      d.angle_code = d.series;
    }
    read_suffixes(rest, d);
    return true;
  }
  return false;
}

/// C114HE, ZSB114C
bool read_barden(std::string_view text, Designation& d) {
  const bool ceramic = text.starts_with('C');
  if (ceramic) text.remove_prefix(1);
  const bool small_balls = text.starts_with("ZSB");
  if (small_balls) text.remove_prefix(3);
  const std::size_t size = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, size);
  std::string_view rest = text.substr(size);
  if (!small_balls && !rest.starts_with('H')) return false;
  for (const DigitSeries& series : barden_series) {
    if (!digits.starts_with(series.digits) || digits.size() != series.digits.size() + 2) continue;
    d.series = series.digits;
    d.dimensions = series.dimensions;
    d.bore_code = digits.substr(series.digits.size());
    d.ceramic_balls = ceramic;
    if (ceramic) d.ball_code = "C";
    if (rest.starts_with('H')) rest.remove_prefix(1);
    constexpr std::array angles{AngleCode{"Barden", "C", 15.0}, AngleCode{"Barden", "E", 25.0}};
    read_angle(rest, angles, d);
    return true;
  }
  return false;
}

/// "70" and "14" of 7014, "719" and "14" of 71914, "79" and "14" of NSK's 7914.
bool split_digits(std::string_view digits, Designation& d) {
  if (digits.size() != 4 && digits.size() != 5) return false;
  d.series = digits.substr(0, digits.size() - 2);
  d.bore_code = digits.substr(digits.size() - 2);
  for (const DigitSeries& known : digit_series)
    if (known.digits == d.series) d.dimensions = known.dimensions;
  return true;
}

}  // namespace

std::string Designation::size() const {
  if (bore_code.empty()) return {};
  for (const DigitSeries& known : digit_series)
    if (known.digits.starts_with('6') && known.dimensions == dimensions)
      return std::string(known.digits) + bore_code;
  return {};
}

std::optional<BoundaryDimensions> Designation::boundary() const {
  return boundary_dimensions(dimensions, bore_code);
}

Designation read_designation(std::string_view given) {
  Designation d;
  const std::string all = in_capitals(given);
  if (read_robust(all, d)) return d;
  std::string_view text = all;
  for (const Prefix& p : ntn_prefixes)
    if (text.starts_with(p.code)) {
      text.remove_prefix(p.code.size());
      if (text.starts_with('-')) text.remove_prefix(1);
      d.ceramic_balls = d.ceramic_balls || p.ceramic_balls;
      if (p.ceramic_balls) d.ball_code = p.code;
    }
  if (read_ntn(text, d) || read_snfa(text, d) || read_barden(text, d)) return d;
  const Prefix* const prefix = prefix_of(text);
  if (const OtherType* const other = prefix ? nullptr : other_type_of(text)) {
    d.other_type = other->words;
    return d;
  }
  if (prefix) {
    text.remove_prefix(prefix->code.size());
    d.ceramic_balls = d.ceramic_balls || prefix->ceramic_balls;
    if (prefix->ceramic_balls) d.ball_code = prefix->code;
  }
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, end);
  if (!prefix)
    d.other_type = text.substr(end).starts_with("TAC") ? of_screws : type_of_digits(digits);
  if (!d.other_type.empty() || !split_digits(digits, d)) return d;
  std::string_view rest = text.substr(end);
  while (rest.starts_with('-')) rest.remove_prefix(1);
  if (rest.starts_with("UC") || rest.starts_with("UAD")) rest.remove_prefix(1);  // NTN's U: ULTAGE
  const auto stands_alone = [](std::string_view code) {
    return code.size() == 1 || std::isalpha(static_cast<unsigned char>(code[1])) == 0;
  };
  for (const AngleCode& code : angle_codes)
    // DB and DF are arrangements.
    if (rest.starts_with(code.code) && (code.code != "D" || stands_alone(rest))) {
      d.contact_angle = code.angle_deg * degree;
      d.angle_code = code.code;
      rest.remove_prefix(code.code.size());
      break;
    }
  read_suffixes(rest, d);
  return d;
}

void require_angular_contact(std::string_view designation) {
  const Designation d = read_designation(designation);
  if (d.other_type.empty()) return;
  constexpr std::string_view of_rollers = "a cylindrical roller bearing";
  throw text::InputError(
      fmt::format("bearing {} is {}: the catalogue has only single-row angular-contact ball "
                  "bearings, such as 7014 C{}",
                  text::quoted(designation), d.other_type,
                  d.other_type == of_rollers ? "; a model of a cylindrical roller bearing has type "
                                               "= \"cylindrical-roller\" (docs/roller.md), and "
                                               "raceway new N1012 writes one"
                                             : ""),
      {.key = "BEARING"});
}

}  // namespace raceway::files
