#include "files/designation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

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
  for (const std::string_view maker : {"SKF", "FAG", "NSK", "NTN", "GMN"})
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
    Prefix{"FAG", "HCRS", true},   Prefix{"FAG", "XCRS", true},   Prefix{"FAG", "HCB", true},
    Prefix{"FAG", "XCB", true},    Prefix{"FAG", "HCS", true},    Prefix{"FAG", "XCS", true},
    Prefix{"FAG", "HC", true},     Prefix{"FAG", "XC", true},     Prefix{"FAG", "RS", false},
    Prefix{"FAG", "HSS", false},   Prefix{"FAG", "HS", false},    Prefix{"FAG", "B", false},
    Prefix{"GMN", "HYKH", true},   Prefix{"GMN", "HYSM", true},   Prefix{"GMN", "HYS", true},
    Prefix{"GMN", "KHS", false},   Prefix{"GMN", "KH", false},    Prefix{"GMN", "SM", false},
    Prefix{"NTN", "5S2LA-", true}, Prefix{"NTN", "5S-", true},    Prefix{"NTN", "5S", true},
    Prefix{"NTN", "2LA-", false},  Prefix{"SKF, GMN", "S", false}};

struct OtherType {
  std::string_view code;  ///< in front of the digits
  std::string_view words;
};
constexpr std::array other_types{OtherType{"NNU", "a double-row cylindrical roller bearing"},
                                 OtherType{"NN", "a double-row cylindrical roller bearing"},
                                 OtherType{"NUP", "a cylindrical roller bearing"},
                                 OtherType{"NU", "a cylindrical roller bearing"},
                                 OtherType{"NJ", "a cylindrical roller bearing"},
                                 OtherType{"NF", "a cylindrical roller bearing"},
                                 OtherType{"HCN", "a cylindrical roller bearing"},
                                 OtherType{"NA", "a needle roller bearing"},
                                 OtherType{"NK", "a needle roller bearing"},
                                 OtherType{"QJ", "a four-point contact ball bearing"},
                                 OtherType{"HR", "a tapered roller bearing"},
                                 OtherType{"4T-", "a tapered roller bearing"},
                                 OtherType{"N", "a cylindrical roller bearing"}};

/// By the digits of ISO's system, where no letter in front says more.
std::string_view type_of_digits(std::string_view digits) {
  if (digits.starts_with("234") && digits.size() == 6)
    return "a double-direction angular-contact thrust ball bearing";
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
  for (const std::string_view code : {"/HC", "SN24", "HYBRID", "/NS"})
    if (d.ball_code.empty() && has(code)) {
      d.ceramic_balls = true;
      d.ball_code = code.starts_with('/') ? code.substr(1) : code;
    }
  for (const std::string_view code : {"DB", "DF", "DT"})
    if (d.arrangement.empty() && has(code)) d.arrangement = code;
  struct Preload {
    std::string_view code, words;
  };
  constexpr std::array preloads{
      Preload{"UL", "light"},       Preload{"UM", "medium"},     Preload{"UH", "heavy"},
      Preload{"GA", "light"},       Preload{"GB", "medium"},     Preload{"GC", "heavy"},
      Preload{"GL", "extra light"}, Preload{"GN", "light"},      Preload{"GM", "medium"},
      Preload{"GH", "heavy"},       Preload{"EL", "extra light"}};
  for (const Preload& p : preloads)
    if (d.preload.empty() && has(p.code)) d.preload = p.words;
}

/// 70BNR10H: bore, series, material.
bool read_robust(std::string_view text, Designation& d) {
  for (const AngleCode& code : robust_codes) {
    const std::size_t at = text.find(code.code);
    if (at == text.npos || at == 0 ||
        !std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at),
                     is_decimal_digit))
      continue;
    const std::string_view behind = text.substr(at + code.code.size());
    if (!behind.starts_with("10") && !behind.starts_with("19")) continue;
    int bore = 0;
    for (const char c : text.substr(0, at)) bore = 10 * bore + (c - '0');
    d.series = behind.starts_with("10") ? "70" : "719";
    if (bore % 5 == 0) d.bore_code = fmt::format("{:02}", bore / 5);
    d.contact_angle = code.angle_deg * degree;
    d.angle_code = code.code;
    const std::string_view material = behind.substr(2);
    d.ceramic_balls = material.starts_with('H') || material.starts_with('X');
    if (d.ceramic_balls) d.ball_code = material.substr(0, 1);
    return true;
  }
  return false;
}

/// "70" and "14" of 7014, "719" and "14" of 71914, "79" and "14" of NSK's 7914.
bool split_digits(std::string_view digits, Designation& d) {
  if (digits.size() != 4 && digits.size() != 5) return false;
  d.series = digits.substr(0, digits.size() - 2);
  d.bore_code = digits.substr(digits.size() - 2);
  return true;
}

}  // namespace

std::string Designation::size() const {
  if (bore_code.empty()) return {};
  if (series == "70" || series == "60") return "60" + bore_code;
  if (series == "719" || series == "79" || series == "619") return "619" + bore_code;
  if (series == "718" || series == "78" || series == "618") return "618" + bore_code;
  if (series == "72" || series == "62") return "62" + bore_code;
  return {};
}

Designation read_designation(std::string_view given) {
  Designation d;
  const std::string all = in_capitals(given);
  if (read_robust(all, d)) return d;
  std::string_view text = all;
  const Prefix* const prefix = prefix_of(text);
  if (const OtherType* const other = prefix ? nullptr : other_type_of(text)) {
    d.other_type = other->words;
    return d;
  }
  if (prefix) {
    text.remove_prefix(prefix->code.size());
    d.ceramic_balls = prefix->ceramic_balls;
    if (prefix->ceramic_balls) d.ball_code = prefix->code.substr(0, prefix->code.find('-'));
  }
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, end);
  if (!prefix) d.other_type = type_of_digits(digits);
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
      fmt::format(
          "bearing {} is {}: the catalogue has single-row angular-contact ball bearings, as "
          "7014 C{}",
          text::quoted(designation), d.other_type,
          d.other_type == of_rollers
              ? "; a model of rollers has type = \"cylindrical-roller\" (docs/roller.md)"
              : ""),
      {.key = "BEARING"});
}

}  // namespace raceway::files
