#include "text/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "record/units.h"
#include "text/names.h"

namespace raceway::text {
namespace {

using D = Dimension;

constexpr double kgf = 9.80665, one_inch = 25.4e-3, one_foot = 12 * one_inch;
constexpr double pound = 4.4482216152605, ounce = pound / 16.0;

constexpr std::array all_units{
    Unit{"Nmm", "N mm", D::moment, N_mm, 0, "N-mm", "nmm newtonmillimeter newtonmillimetre"},
    Unit{"Nm", "N m", D::moment, 1.0, 0, "N-m",
         "nm newtonmeter newtonmetre newton-meter newton-metre"},
    Unit{"mNm", "mN m", D::moment, N_mm, 0, "mN-m"},
    Unit{"uNm", "uN m", D::moment, 1e-6, 0, "uN-m"},
    Unit{"cNm", "cN m", D::moment, 1e-2, 0, "cN-m"},
    Unit{"dNm", "dN m", D::moment, 0.1, 0, "dN-m"},
    Unit{"Ncm", "N cm", D::moment, 1e-2, 0, "N-cm", "ncm"},
    Unit{"daNm", "daN m", D::moment, 10.0, 0, "daN-m"},
    Unit{"kNm", "kN m", D::moment, 1e3, 0, "kN-m", "knm"},
    Unit{"kgfmm", "kgf mm", D::moment, kgf* mm, 0, "", "kpmm kgmm kgf-mm kg-mm kgfmm"},
    Unit{"kgfcm", "kgf cm", D::moment, kgf * 1e-2, 0, "", "kpcm kgcm kgf-cm kg-cm kgfcm"},
    Unit{"kgfm", "kgf m", D::moment, kgf, 0, "", "kpm kgm kgf-m kg-m kgfm"},
    Unit{"gfmm", "gf mm", D::moment, 1e-3 * kgf* mm, 0, "", "gmm gf-mm g-mm gfmm"},
    Unit{"gfcm", "gf cm", D::moment, 1e-3 * kgf * 1e-2, 0, "", "gcm gf-cm g-cm gfcm"},
    Unit{"lbfin", "lbf in", D::moment, pound* one_inch, 0, "",
         "lb-in in-lb inlb inlbf lbin lbfin lbf-in in-lbf lbs-in in-lbs lbsin inlbs"},
    Unit{"lbfft", "lbf ft", D::moment, pound* one_foot, 0, "",
         "lb-ft ft-lb ftlb ftlbf lbft lbfft lbf-ft ft-lbf lbs-ft ft-lbs lbsft ftlbs"},
    Unit{"ozfin", "ozf in", D::moment, ounce* one_inch, 0, "",
         "oz-in in-oz ozin inoz ozfin inozf ozf-in in-ozf"},
    Unit{"N", "N", D::force, 1.0, 0, "", "newton newtons"},
    Unit{"kN", "kN", D::force, 1e3, 0, "", "kn kilonewton kilonewtons"},
    Unit{"daN", "daN", D::force, 10.0},
    Unit{"cN", "cN", D::force, 1e-2},
    Unit{"mN", "mN", D::force, 1e-3},
    Unit{"MN", "MN", D::force, 1e6},
    Unit{"kgf", "kgf", D::force, kgf, 0, "", "kp kg kgf kilopond"},
    Unit{"gf", "gf", D::force, 1e-3 * kgf},
    Unit{"lbf", "lbf", D::force, pound, 0, "", "lb lbs lbf lbsf pound pounds"},
    Unit{"ozf", "ozf", D::force, ounce, 0, "", "oz ozf ounce ounces"},
    Unit{"um", "um", D::length, um, 0, "",
         "um micron microns micrometer micrometre micrometers micrometres mikrometer"},
    Unit{"mm", "mm", D::length, mm, 0, "", "mm millimeter millimetre millimeters millimetres"},
    Unit{"m", "m", D::length, 1.0, 0, "", "meter metre meters metres"},
    Unit{"cm", "cm", D::length, 1e-2, 0, "", "cm centimeter centimetre centimeters centimetres"},
    Unit{"nm", "nm", D::length, 1e-9, 0, "", "nanometer nanometre nanometers nanometres"},
    Unit{"inch", "inch", D::length, one_inch, 0, "in", "inch inches zoll"},
    Unit{"mil", "mil", D::length, 1e-3 * one_inch, 0, "", "mil mils thou"},
    Unit{"rpm", "rpm", D::speed, rpm, 0,
         "1_min min-1 min^-1 per_min U_min rev_min r_min RPM Rpm 1_Min Upm UPM _min",
         "rpm upm 1_minute rev_minute revs_min rotations_min turns_min tr_min omw_min giri_min "
         "umdr_min per_minute u_minute"},
    Unit{"1_s", "1/s", D::speed, 2.0 * pi, 0, "s-1 s^-1 per_s rev_s r_s U_s Hz rps _s",
         "hz hertz rps 1_sec 1_second rev_sec revs_sec revs_s r_sec u_sec per_second"},
    Unit{"rad_s", "rad/s", D::speed, 1.0, 0, "rads rads-1 rads^-1",
         "rad_s rad_sec rad_second rads_s rads_sec radian_s radians_s radians_sec"},
    Unit{"deg_s", "deg/s", D::speed, degree, 0, "degs-1 degs^-1",
         "deg_s deg_sec deg_second degs_s degs_sec degree_s degrees_s degrees_sec"},
    Unit{"krpm", "krpm", D::speed, 1e3 * rpm, 0, "10001_min 1000min-1",
         "krpm 1000rpm x1000rpm 10^3rpm"},
    Unit{"m_min", "m/min", D::feed, 1.0 / 60.0, 0, "", "m_minute meter_min"},
    Unit{"mm_min", "mm/min", D::feed, mm / 60.0, 0, "", "mm_minute"},
    Unit{"m_s", "m/s", D::feed, 1.0, 0, "", "m_sec m_second"},
    Unit{"mm_s", "mm/s", D::feed, mm, 0, "", "mm_sec mm_second"},
    Unit{"inch_min", "inch/min", D::feed, one_inch / 60.0, 0, "", "in_min inch_min ipm"},
    Unit{"C", "C", D::temperature, 1.0, celsius_zero, "GradC",
         "degc deg_c celsius gradc gradcelsius degcelsius degreec degreesc degreescelsius"},
    Unit{"K", "K", D::temperature, 1.0, 0, "", "kelvin degk deg_k"},
    Unit{"F", "F", D::temperature, 1.0 / 1.8, celsius_zero - 32.0 / 1.8, "",
         "degf deg_f fahrenheit gradf degfahrenheit degreef degreesf degreesfahrenheit"},
    Unit{"s", "s", D::time, 1.0, 0, "S", "sec secs second seconds sek sekunde sekunden"},
    Unit{"ms", "ms", D::time, 1e-3, 0, "", "msec msek millisecond milliseconds"},
    Unit{"us", "us", D::time, 1e-6, 0, "", "usec microsecond microseconds"},
    Unit{"ns", "ns", D::time, 1e-9, 0, "", "nsec nanosecond nanoseconds"},
    Unit{"min", "min", D::time, 60.0, 0, "", "min mins minute minutes minuten"},
    Unit{"h", "h", D::time, 3600.0, 0, "", "hr hrs hour hours std stunde stunden"},
    Unit{"d", "d", D::time, 86400.0, 0, "", "day days tag tage"},
    Unit{"deg", "deg", D::angle, degree, 0, "", "deg degree degrees"},
    Unit{"mrad", "mrad", D::angle, mrad, 0, "", "milliradian milliradians"},
    Unit{"rad", "rad", D::angle, 1.0, 0, "", "radian radians"},
    Unit{"urad", "urad", D::angle, 1e-6, 0, "", "microradian microradians"},
    Unit{"arcsec", "arcsec", D::angle, degree / 3600.0, 0, "", "arcsec arcsecond arcseconds"},
    Unit{"MPa", "MPa", D::pressure, MPa},
    Unit{"GPa", "GPa", D::pressure, GPa},
    Unit{"bar", "bar", D::pressure, 1e5},
    Unit{"W", "W", D::power, 1.0, 0, "", "watt watts"},
    Unit{"kW", "kW", D::power, 1e3, 0, "", "kw kilowatt kilowatts"},
    Unit{"mm2_s", "mm2/s", D::viscosity, mm2_per_s, 0, "cSt", "cst"},
    Unit{"N_um", "N/um", D::stiffness, N_per_um},
    Unit{"V", "V", D::voltage, 1.0, 0, "", "volt volts"},
    Unit{"mV", "mV", D::voltage, 1e-3, 0, "", "millivolt millivolts"},
    Unit{"uV", "uV", D::voltage, 1e-6, 0, "", "microvolt microvolts"},
    Unit{"A", "A", D::current, 1.0, 0, "", "ampere amperes amp amps"},
    Unit{"mA", "mA", D::current, 1e-3, 0, "", "milliampere milliamperes"},
    Unit{"l_min", "l/min", D::flow, 1.0 / 60000.0, 0, "L_min", "lpm"},
    Unit{"l_h", "l/h", D::flow, 1.0 / 3.6e6, 0, "L_h"},
    Unit{"m3_h", "m3/h", D::flow, 1.0 / 3600.0},
    Unit{"percent", "%", D::share, 0.01, 0, "%", "pct"}};

/// Without blanks, brackets and dots of products; micro is "u", a degree sign "deg", a superscript
/// the digit, a slash "_".
std::string in_short(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 16> written{
      {{"\u00b5", "u"},
       {"\u03bc", "u"},
       {"\u00b0", "deg"},
       {"\u00ba", "deg"},
       {"\u00b7", ""},
       {"\u22c5", ""},
       {"\u2022", ""},
       {"\u2219", ""},
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
  const std::string small = lower_case(text);
  for (const Unit& unit : all_units)
    if ((!dimension || unit.dimension == *dimension) && has_word(unit.names, small)) return &unit;
  return nullptr;
}

bool states_no_unit(std::string_view text) {
  return text.empty() || text == "-" || text == "[-]" || text == "(-)";
}

std::string listed_units(Dimension dimension) {
  std::vector<std::string> known;
  for (const Unit& unit : all_units)
    if (unit.dimension == dimension) known.emplace_back(unit.suffix);
  return listed(known, "or");
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
    return {trimmed(header.substr(0, bracket)), in_brackets(header)};
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

std::string_view in_brackets(std::string_view header) {
  header = trimmed(header);
  const std::size_t bracket = opening_bracket(header);
  if (bracket == header.npos || bracket == 0) return {};
  return trimmed(header.substr(bracket + 1, header.size() - bracket - 2));
}

const Unit* unit_at_end(std::string_view header, Dimension dimension) {
  header = trimmed(header);
  for (std::size_t at = header.find_first_of(" ,"); at != header.npos;
       at = header.find_first_of(" ,", at + 1)) {
    const std::string_view end = trimmed(header.substr(at + 1));
    if (const Unit* const unit = end.size() > 1 ? find_unit(end, dimension) : nullptr) return unit;
  }
  return nullptr;
}

double column_unit(std::string_view column) {
  if (column == "lambda_min") return 1.0;  // the least film ratio: no minutes
  for (std::size_t at = column.find('_'); at != column.npos; at = column.find('_', at + 1))
    for (const Unit& unit : all_units)
      if (unit.suffix == column.substr(at + 1)) return unit.factor;
  return 1.0;
}

}  // namespace raceway::text
