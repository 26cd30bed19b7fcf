#include "files/oil_grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <vector>

#include "text/csv.h"
#include "text/error.h"

namespace raceway::files {
namespace {

// By ISO 2909 (ASTM D 2270) an oil of index 100 has at 40 C the viscosity H(v), v at 100 C; below 2
// mm2/s, where the standard ends, by its first formula.
constexpr std::array<OilGrade, 11> grades{{{5, 1.7},
                                           {7, 2.1},
                                           {10, 2.7},
                                           {15, 3.4},
                                           {22, 4.3},
                                           {32, 5.4},
                                           {46, 6.8},
                                           {68, 8.7},
                                           {100, 11.4},
                                           {150, 15.0},
                                           {220, 19.4}}};

}  // namespace

OilGrade oil_grade(std::string_view words) {
  std::string plain;
  for (const char c : words)
    if (c != ' ') plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string_view number = plain;
  for (const std::string_view prefix : {"ISO", "VG"})
    if (number.starts_with(prefix)) number.remove_prefix(prefix.size());
  int grade = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), grade);
  const auto found = std::find_if(grades.begin(), grades.end(),
                                  [&](const OilGrade& g) { return g.grade == grade; });
  if (error == std::errc() && end == number.data() + number.size() && found != grades.end())
    return *found;
  std::vector<int> all;
  for (const OilGrade& g : grades) all.push_back(g.grade);
  throw text::InputError(fmt::format("oil {}: not a known ISO VG grade; known grades: {}",
                                     text::quoted(words), fmt::join(all, ", ")),
                         {.key = "--oil"});
}

std::string lubricant_lines(std::string_view oil) {
  if (oil.empty())
    return "\n[lubricant]                        # assumed: a thin spindle oil; enter the values "
           "of your oil\n"
           "viscosity_40C_mm2_s = 22.0         # for a grease: viscosity of its base oil\n"
           "viscosity_100C_mm2_s = 4.8\n";
  const OilGrade found = oil_grade(oil);
  return fmt::format(
      "\n[lubricant]\n"
      "viscosity_40C_mm2_s = {:<13}# ISO VG {}; for a grease: viscosity of its base oil\n"
      "viscosity_100C_mm2_s = {:<12}# assumed: a mineral oil of viscosity index 100\n",
      fmt::format("{:.1f}", 1.0 * found.grade), found.grade, fmt::format("{:.1f}", found.at_100_C));
}

}  // namespace raceway::files
