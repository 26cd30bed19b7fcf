#pragma once

#include <string>
#include <string_view>

#include "record/units.h"

namespace raceway::files {

/// Kinematic viscosities of a mineral oil by its ISO VG grade.
struct OilGrade {
  int grade = 0;            ///< ISO VG grade: viscosity at 40 C by ISO 3448 [mm2/s]
  double at_100_C = unset;  ///< viscosity at 100 C for viscosity index 100, by ISO 2909 [mm2/s]
};

/// Returns the oil for a text such as "VG 32", "ISO VG 32" or "32". Throws text::InputError with a
/// list of all grades for an unknown grade.
[[nodiscard]] OilGrade oil_grade(std::string_view words);

/// Returns the text of the table [lubricant] for a new model file: viscosities of the oil, or of a
/// thin spindle oil if `oil` is empty. Throws text::InputError for an unknown ISO VG grade.
[[nodiscard]] std::string lubricant_lines(std::string_view oil);

}  // namespace raceway::files
