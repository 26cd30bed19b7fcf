#include "files/roller_estimate.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <iterator>

#include "files/boundary_dimensions.h"
#include "files/oil_grade.h"
#include "friction/roller_friction.h"
#include "life/roller_life.h"
#include "text/error.h"

namespace raceway::files {
namespace {

/// Proportions of the printed sizes, in the middle.
constexpr double section_share = 0.485, circle_share = 0.71;

/// Printed of a size: diameter E of the outer raceway [mm], C and C0 [N].
struct PrintedSize {
  std::string_view bore_code;
  double outer_raceway, dynamic_rating, static_rating;
};
/// IBC, High Precision Bearings, TI-I-5050.0/E, 2010, p. 122-127, read in a copy of its text. Sizes
/// whose E that copy has.
constexpr PrintedSize printed_sizes[]{
    {"09", 67.5, 33400, 37600},    {"10", 72.5, 36200, 41700},   {"11", 80.5, 41300, 49800},
    {"12", 85.5, 44300, 55200},    {"13", 91.0, 45500, 59000},   {"16", 113.5, 76900, 98500},
    {"17", 118.5, 78500, 105000},  {"19", 132.0, 97000, 130000}, {"21", 145.5, 113000, 154000},
    {"22", 155.0, 164800, 189800}, {"24", 165.0, 175000, 208000}};

const PrintedSize* printed_size(std::string_view bore_code) {
  for (const PrintedSize& size : printed_sizes)
    if (size.bore_code == bore_code) return &size;
  return nullptr;
}

/// In capitals, without blanks.
std::string plain_designation(std::string_view designation) {
  std::string text;
  for (const char c : designation)
    if (!std::isspace(static_cast<unsigned char>(c)))
      text.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  return text;
}

/// "10" and "12" of N1012; nothing where no digits follow.
std::string digits_behind(std::string_view text, std::string_view letters) {
  if (!text.starts_with(letters)) return {};
  text.remove_prefix(letters.size());
  std::string digits;
  for (const char c : text) {
    if (!std::isdigit(static_cast<unsigned char>(c))) break;
    digits.push_back(c);
  }
  return digits;
}

std::string marked_line(std::string_view key, const std::string& value, std::string_view remark) {
  const std::string text = fmt::format("{} = {}", key, value);
  return remark.empty() ? text + "\n" : fmt::format("{:<34} # {}\n", text, remark);
}

}  // namespace

bool names_rollers(std::string_view designation) {
  const std::string text = plain_designation(designation);
  for (const char* const letters : {"N", "NU", "NJ", "NUP", "NN", "NNU"})
    if (digits_behind(text, letters).size() >= 3) return true;
  return false;
}

EstimatedRollers estimated_rollers(std::string_view designation) {
  const std::string digits = digits_behind(plain_designation(designation), "N");
  const auto refuse = [&](const std::string& why) {
    throw text::InputError(
        fmt::format(
            "{}: {}; write the table [bearing] with type = \"cylindrical-roller\", roller_count, "
            "roller_diameter_mm, roller_length_mm and pitch_diameter_mm (docs/roller.md)",
            designation, why),
        {.key = "BEARING"});
  };
  if (digits.size() != 4 || !digits.starts_with("10"))
    refuse("the program can estimate only cylindrical roller bearings of series N10");
  const auto size = boundary_dimensions("10", digits.substr(2));
  if (!size) refuse("the table of ISO 15 has no boundary dimensions for this size");
  bearing::RollerGeometry g;
  g.bore = size->bore;
  g.outer_diameter = size->outer_diameter;
  g.width = size->width;
  g.pitch_diameter = 0.5 * (g.bore + g.outer_diameter);
  EstimatedRollers result{.designation = std::string(designation)};
  if (const PrintedSize* const printed = printed_size(digits.substr(2))) {
    result.outer_raceway = printed->outer_raceway * mm;
    result.dynamic_rating = printed->dynamic_rating;
    result.static_rating = printed->static_rating;
    g.roller_diameter = result.outer_raceway - g.pitch_diameter;
    g.roller_length = g.roller_diameter;
    g.roller_count = 1;  // C0 is in proportion to Z
    g.roller_count =
        static_cast<int>(std::lround(result.static_rating / life::static_load_rating(g)));
  } else {
    const double section = 0.5 * (g.outer_diameter - g.bore);
    g.roller_diameter = std::round(section_share * section / (0.5 * mm)) * (0.5 * mm);
    g.roller_length = g.roller_diameter;
    g.roller_count =
        static_cast<int>(std::lround(circle_share * pi * g.pitch_diameter / g.roller_diameter));
  }
  result.geometry = bearing::validated(g);
  return result;
}

std::string estimated_model_text(const EstimatedRollers& bearing, friction::FrictionLaw law,
                                 std::string_view roller_material, std::string_view oil) {
  const bearing::RollerGeometry& g = bearing.geometry;
  const auto length = [](double value) { return fmt::format("{:.6g}", value / mm); };
  std::string text = fmt::format(
      "# Model of an {} on a rig, an axially free cylindrical roller bearing.\n"
      "# The roller data are estimated from {}: replace them by your own values.\n\n"
      "[bearing]\n",
      bearing.designation,
      bearing.printed() ? "catalogue data of a manufacturer (IBC, 2010)"
                        : "the boundary dimensions");
  const auto add = [&](std::string_view key, const std::string& value,
                       std::string_view remark = {}) { text += marked_line(key, value, remark); };
  add("type", "\"cylindrical-roller\"");
  add("name", fmt::format("\"{}\"", bearing.designation));
  add("roller_count", fmt::format("{}", g.roller_count),
      bearing.printed()
          ? fmt::format("estimated from the printed C0 = {:.0f} N", bearing.static_rating)
          : "estimated");
  add("roller_diameter_mm", length(g.roller_diameter),
      bearing.printed()
          ? fmt::format("estimated: printed outer raceway diameter {} mm minus pitch diameter",
                        length(bearing.outer_raceway))
          : fmt::format("estimated: {} times (outer diameter - bore) / 2", section_share));
  add("roller_length_mm", length(g.roller_length),
      "estimated: equal to the roller diameter; without chamfers");
  add("pitch_diameter_mm", length(g.pitch_diameter), "estimated: mean of bore and outer diameter");
  add("bore_mm", length(g.bore), "from dimension series 10");
  add("outer_diameter_mm", length(g.outer_diameter), "from dimension series 10");
  add("width_mm", length(g.width), "from dimension series 10");
  add("radial_clearance_um", "0", "diametral clearance, mounted; below 0: preload");
  add("profile", "\"iso\"", "logarithmic crowning; or \"none\"");
  add("roller_material", fmt::format("\"{}\"", roller_material),
      "\"steel\" or \"silicon-nitride\"");
  text += fmt::format("# With these numbers C = {:.0f} N and C0 = {:.0f} N",
                      life::dynamic_load_rating(g), life::static_load_rating(g));
  text += bearing.printed() ? fmt::format("; the catalogue has {:.0f} N and {:.0f} N.\n",
                                          bearing.dynamic_rating, bearing.static_rating)
                            : ".\n";
  text += lubricant_lines(oil);
  add("supply", "\"oil-air\"", "or \"grease\", \"bath\", \"jet\"");
  text += "\n[friction]\n";
  add("law", fmt::format("\"{}\"", friction::name(law)), "or \"palmgren\", \"skf\"");
  for (const friction::Parameter& p : friction::parameters(law))
    add(p.name, fmt::format("{:g}", p.initial));
  add("f1_load", "\"rollers\"",
      "sum of the roller loads; or \"F_r\", the radial load, as in the published laws");
  return text;
}

}  // namespace raceway::files
