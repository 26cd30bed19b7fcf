#include "files/boundary_dimensions.h"

#include <algorithm>
#include <array>
#include <string>

#include "record/units.h"

namespace raceway::files {
namespace {

constexpr std::array<std::string_view, 5> dimension_series_of_columns{"18", "19", "10", "02", "03"};

struct Size {
  int outer_diameter, width;  ///< [mm]; 0 where there is none
};
/// One bore in the dimension series 18, 19, 10, 02 and 03.
struct Sizes {
  std::string_view bore_code;
  int bore;  ///< [mm]
  std::array<Size, 5> by_series;
};
constexpr std::array all_sizes{
    Sizes{"00", 10, {{{19, 5}, {22, 6}, {26, 8}, {30, 9}, {35, 11}}}},
    Sizes{"01", 12, {{{21, 5}, {24, 6}, {28, 8}, {32, 10}, {37, 12}}}},
    Sizes{"02", 15, {{{24, 5}, {28, 7}, {32, 9}, {35, 11}, {42, 13}}}},
    Sizes{"03", 17, {{{26, 5}, {30, 7}, {35, 10}, {40, 12}, {47, 14}}}},
    Sizes{"04", 20, {{{32, 7}, {37, 9}, {42, 12}, {47, 14}, {52, 15}}}},
    Sizes{"05", 25, {{{37, 7}, {42, 9}, {47, 12}, {52, 15}, {62, 17}}}},
    Sizes{"06", 30, {{{42, 7}, {47, 9}, {55, 13}, {62, 16}, {72, 19}}}},
    Sizes{"07", 35, {{{47, 7}, {55, 10}, {62, 14}, {72, 17}, {80, 21}}}},
    Sizes{"08", 40, {{{52, 7}, {62, 12}, {68, 15}, {80, 18}, {90, 23}}}},
    Sizes{"09", 45, {{{58, 7}, {68, 12}, {75, 16}, {85, 19}, {100, 25}}}},
    Sizes{"10", 50, {{{65, 7}, {72, 12}, {80, 16}, {90, 20}, {110, 27}}}},
    Sizes{"11", 55, {{{72, 9}, {80, 13}, {90, 18}, {100, 21}, {120, 29}}}},
    Sizes{"12", 60, {{{78, 10}, {85, 13}, {95, 18}, {110, 22}, {130, 31}}}},
    Sizes{"13", 65, {{{85, 10}, {90, 13}, {100, 18}, {120, 23}, {140, 33}}}},
    Sizes{"14", 70, {{{90, 10}, {100, 16}, {110, 20}, {125, 24}, {150, 35}}}},
    Sizes{"15", 75, {{{95, 10}, {105, 16}, {115, 20}, {130, 25}, {160, 37}}}},
    Sizes{"16", 80, {{{100, 10}, {110, 16}, {125, 22}, {140, 26}, {170, 39}}}},
    Sizes{"17", 85, {{{110, 13}, {120, 18}, {130, 22}, {150, 28}, {180, 41}}}},
    Sizes{"18", 90, {{{115, 13}, {125, 18}, {140, 24}, {160, 30}, {190, 43}}}},
    Sizes{"19", 95, {{{120, 13}, {130, 18}, {145, 24}, {170, 32}, {200, 45}}}},
    Sizes{"20", 100, {{{125, 13}, {140, 20}, {150, 24}, {180, 34}, {215, 47}}}},
    Sizes{"21", 105, {{{130, 13}, {145, 20}, {160, 26}, {190, 36}, {225, 49}}}},
    Sizes{"22", 110, {{{140, 16}, {150, 20}, {170, 28}, {200, 38}, {240, 50}}}},
    Sizes{"24", 120, {{{150, 16}, {165, 22}, {180, 28}, {215, 40}, {260, 55}}}},
    Sizes{"26", 130, {{{165, 18}, {180, 24}, {200, 33}, {230, 40}, {0, 0}}}},
    Sizes{"28", 140, {{{175, 18}, {190, 24}, {210, 33}, {250, 42}, {0, 0}}}},
    Sizes{"30", 150, {{{190, 20}, {210, 28}, {225, 35}, {270, 45}, {0, 0}}}},
    Sizes{"32", 160, {{{200, 20}, {220, 28}, {240, 38}, {290, 48}, {0, 0}}}},
    Sizes{"34", 170, {{{215, 22}, {230, 28}, {260, 42}, {310, 52}, {0, 0}}}},
    Sizes{"36", 180, {{{225, 22}, {250, 33}, {280, 46}, {320, 52}, {0, 0}}}},
    Sizes{"38", 190, {{{240, 24}, {260, 33}, {290, 46}, {340, 55}, {0, 0}}}},
    Sizes{"40", 200, {{{250, 24}, {280, 38}, {310, 51}, {360, 58}, {0, 0}}}}};

}  // namespace

std::optional<BoundaryDimensions> boundary_dimensions(std::string_view dimension_series,
                                                      std::string_view bore_code) {
  const auto series = std::find(dimension_series_of_columns.begin(),
                                dimension_series_of_columns.end(), dimension_series);
  const auto sizes = std::find_if(all_sizes.begin(), all_sizes.end(),
                                  [&](const Sizes& s) { return s.bore_code == bore_code; });
  if (series == dimension_series_of_columns.end() || sizes == all_sizes.end()) return std::nullopt;
  const Size& size =
      sizes->by_series[static_cast<std::size_t>(series - dimension_series_of_columns.begin())];
  if (size.outer_diameter == 0) return std::nullopt;
  return BoundaryDimensions{sizes->bore * mm, size.outer_diameter * mm, size.width * mm};
}

std::string_view bore_code_of(int bore_mm) {
  for (const Sizes& s : all_sizes)
    if (s.bore == bore_mm) return s.bore_code;
  return {};
}

}  // namespace raceway::files
