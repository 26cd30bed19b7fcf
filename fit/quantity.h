#pragma once

#include <string_view>

#include "bearing/units.h"
#include "effects/effect.h"
#include "fit/data_set.h"

namespace raceway::fit {

/// How a measured quantity is called and written for people and in files.
struct QuantityText {
  std::string_view name;      ///< as in the JSON results
  std::string_view in_words;  ///< "friction torque"
  std::string_view unit;      ///< "N mm"
  std::string_view key_unit;  ///< as names of columns and JSON results have it: "Nmm"
  double factor;              ///< one of `unit` in SI
};

[[nodiscard]] constexpr QuantityText text_of(Quantity quantity) {
  return quantity == Quantity::friction_torque
             ? QuantityText{"friction_torque", "friction torque", "N mm", "Nmm", N_mm}
             : QuantityText{"axial_displacement", "axial displacement", "um", "um", um};
}

/// What the quantity is measured on.
[[nodiscard]] constexpr effects::Subject subject_of(Quantity quantity) {
  return quantity == Quantity::friction_torque ? effects::Subject::bearing
                                               : effects::Subject::shaft;
}

}  // namespace raceway::fit
