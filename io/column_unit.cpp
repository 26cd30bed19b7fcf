#include "io/column_unit.h"

#include <array>

#include "record/units.h"

namespace raceway::io {
namespace {

struct Unit {
  std::string_view suffix;
  double factor;
};

// Where one suffix ends another, the longer one comes first.
constexpr std::array units{Unit{"_N_um", N_per_um}, Unit{"_Nmm", N_mm},   Unit{"_mm2_s", mm2_per_s},
                           Unit{"_rpm", rpm},       Unit{"_deg", degree}, Unit{"_mrad", mrad},
                           Unit{"_um", um},         Unit{"_mm", mm},      Unit{"_MPa", MPa},
                           Unit{"_GPa", GPa},       Unit{"_kW", 1e3}};

}  // namespace

double column_unit(std::string_view column) {
  for (const Unit& unit : units)
    if (column.ends_with(unit.suffix)) return unit.factor;
  return 1.0;
}

}  // namespace raceway::io
