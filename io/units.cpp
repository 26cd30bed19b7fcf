#include "io/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/names.h"
#include "record/units.h"

namespace raceway::io {
namespace {

using D = Dimension;

constexpr double kgf = 9.80665, one_inch = 25.4e-3, pound = 4.4482216152605;

constexpr std::array all_units{
    Unit{"Nmm", "N mm", D::moment, N_mm, 0, "N-mm"},
    Unit{"Nm", "N m", D::moment, 1.0, 0, "N-m"},
    Unit{"mNm", "mN m", D::moment, N_mm, 0, "mN-m"},
    Unit{"uNm", "uN m", D::moment, 1e-6},
    Unit{"Ncm", "N cm", D::moment, 1e-2, 0, "N-cm"},
    Unit{"kNm", "kN m", D::moment, 1e3},
    Unit{"kgfmm", "kgf mm", D::moment, kgf* mm, 0, "kpmm"},
    Unit{"kgfm", "kgf m", D::moment, kgf, 0, "kpm"},
    Unit{"lbfin", "lbf in", D::moment, pound* one_inch, 0, "lb-in in-lb inlb inlbf lbin"},
    Unit{"N", "N", D::force, 1.0},
    Unit{"kN", "kN", D::force, 1e3},
    Unit{"daN", "daN", D::force, 10.0},
    Unit{"mN", "mN", D::force, 1e-3},
    Unit{"kgf", "kgf", D::force, kgf, 0, "kp"},
    Unit{"lbf", "lbf", D::force, pound, 0, "lb"},
    Unit{"um", "um", D::length, um, 0, "micron microns"},
    Unit{"mm", "mm", D::length, mm},
    Unit{"m", "m", D::length, 1.0},
    Unit{"cm", "cm", D::length, 1e-2},
    Unit{"nm", "nm", D::length, 1e-9},
    Unit{"inch", "inch", D::length, one_inch, 0, "in"},
    Unit{"mil", "mil", D::length, 1e-3 * one_inch, 0, "mils thou"},
    Unit{"rpm", "rpm", D::speed, rpm, 0,
         "1_min min-1 min^-1 per_min U_min rev_min r_min RPM Rpm 1_Min Upm UPM"},
    Unit{"1_s", "1/s", D::speed, 2.0 * pi, 0, "s-1 s^-1 per_s rev_s r_s U_s Hz rps"},
    Unit{"rad_s", "rad/s", D::speed, 1.0, 0, "rads"},
    Unit{"krpm", "krpm", D::speed, 1e3 * rpm},
    Unit{"m_min", "m/min", D::feed, 1.0 / 60.0},
    Unit{"mm_min", "mm/min", D::feed, mm / 60.0},
    Unit{"m_s", "m/s", D::feed, 1.0},
    Unit{"mm_s", "mm/s", D::feed, mm},
    Unit{"C", "C", D::temperature, 1.0, celsius_zero, "degC deg_C Celsius celsius GradC"},
    Unit{"K", "K", D::temperature, 1.0, 0, "Kelvin kelvin"},
    Unit{"F", "F", D::temperature, 1.0 / 1.8, celsius_zero - 32.0 / 1.8, "degF deg_F Fahrenheit"},
    Unit{"s", "s", D::time, 1.0, 0, "sec Sek sek S"},
    Unit{"ms", "ms", D::time, 1e-3},
    Unit{"us", "us", D::time, 1e-6},
    Unit{"min", "min", D::time, 60.0, 0, "Min"},
    Unit{"h", "h", D::time, 3600.0, 0, "hr Std"},
    Unit{"d", "d", D::time, 86400.0, 0, "day days"},
    Unit{"deg", "deg", D::angle, degree},
    Unit{"mrad", "mrad", D::angle, mrad},
    Unit{"rad", "rad", D::angle, 1.0},
    Unit{"MPa", "MPa", D::pressure, MPa},
    Unit{"GPa", "GPa", D::pressure, GPa},
    Unit{"W", "W", D::power, 1.0},
    Unit{"kW", "kW", D::power, 1e3},
    Unit{"mm2_s", "mm2/s", D::viscosity, mm2_per_s, 0, "cSt"},
    Unit{"N_um", "N/um", D::stiffness, N_per_um},
    Unit{"V", "V", D::voltage, 1.0, 0, "Volt volt"},
    Unit{"mV", "mV", D::voltage, 1e-3},
    Unit{"uV", "uV", D::voltage, 1e-6}};

/// Without blanks, brackets, dots of products and degree signs; micro is "u", a superscript the
/// digit, a slash "_".
std::string in_short(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> written{{{"\u00b5", "u"},
                                                                                   {"\u03bc", "u"},
                                                                                   {"\u00b0", ""},
                                                                                   {"\u00ba", ""},
                                                                                   {"\u00b7", ""},
                                                                                   {"\u22c5", ""},
                                                                                   {"\u00b2", "2"},
                                                                                   {"\u207b", "-"},
                                                                                   {"\u00b9", "1"},
                                                                                   {"\u2212", "-"},
                                                                                   {"*", ""},
                                                                                   {".", ""},
                                                                                   {"/", "_"},
                                                                                   {" ", ""}}};
  text = trimmed(text);
  constexpr std::string_view open = "[(<", close = "])>";
  if (text.size() > 2)
    if (const auto kind = open.find(text.front()); kind != open.npos && text.back() == close[kind])
      text = text.substr(1, text.size() - 2);
  std::string result;
  while (!text.empty()) {
    const auto found = std::find_if(written.begin(), written.end(),
                                    [&](const auto& pair) { return text.starts_with(pair.first); });
    if (found != written.end()) {
      result += found->second;
      text.remove_prefix(found->first.size());
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' '))
      return true;
  }
  return false;
}

/// What stands in the brackets at the end of a header, and where they open; npos without.
std::size_t opening_bracket(std::string_view header) {
  if (header.ends_with(']')) return header.rfind('[');
  if (header.ends_with(')')) return header.rfind('(');
  return header.npos;
}

}  // namespace

std::span<const Unit> units() { return all_units; }

const Unit* find_unit(std::string_view spelling, std::optional<Dimension> dimension) {
  // Of a long name, or a comment, every part behind a "_" is asked about.
  constexpr std::size_t longest = 40;
  if (spelling.size() > longest) return nullptr;
  const std::string text = in_short(spelling);
  if (text.empty()) return nullptr;
  for (const Unit& unit : all_units)
    if ((!dimension || unit.dimension == *dimension) &&
        (unit.suffix == text || has_word(unit.spellings, text)))
      return &unit;
  return nullptr;
}

std::string conversion(const Unit& from, const Unit& to) {
  if (from.dimension != Dimension::temperature)
    return fmt::format("1 {} = {:.10g} {}", from.words, from.factor / to.factor, to.words);
  const double shift = to.in_unit(from.to_SI(0.0)), slope = from.factor / to.factor;
  if (slope == 1.0)
    return fmt::format("{} = {} {} {:.10g}", to.words, from.words, shift < 0 ? '-' : '+',
                       shift < 0 ? -shift : shift);
  const double zero = -shift / slope;
  return fmt::format("{} = ({} {} {:.10g}) {} {:.10g}", to.words, from.words, zero < 0 ? '+' : '-',
                     zero < 0 ? -zero : zero, slope < 1 ? '/' : '*', slope < 1 ? 1 / slope : slope);
}

HeaderParts header_parts(std::string_view header) {
  header = trimmed(header);
  const std::size_t bracket = opening_bracket(header);
  if (bracket != header.npos && bracket > 0)
    return {trimmed(header.substr(0, bracket)),
            trimmed(header.substr(bracket + 1, header.size() - bracket - 2))};
  for (const std::string_view word : {" in ", " / "})
    if (const std::size_t at = header.find(word);
        at != header.npos && find_unit(header.substr(at + word.size())))
      return {trimmed(header.substr(0, at)), trimmed(header.substr(at + word.size()))};
  // The longest unit: "N_um" rather than "um".
  for (std::size_t at = header.find('_'); at != header.npos; at = header.find('_', at + 1))
    if (at > 0 && find_unit(header.substr(at + 1)))
      return {header.substr(0, at), header.substr(at + 1)};
  return {header, {}};
}

double column_unit(std::string_view column) {
  if (column == "lambda_min") return 1.0;  // the least film ratio: no minutes
  for (std::size_t at = column.find('_'); at != column.npos; at = column.find('_', at + 1))
    for (const Unit& unit : all_units)
      if (unit.suffix == column.substr(at + 1)) return unit.factor;
  return 1.0;
}

}  // namespace raceway::io
