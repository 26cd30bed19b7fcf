#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spindle/step_response.h"
#include "text/error.h"

/// Step responses computed by another program, such as a finite-element run of a spindle.
namespace raceway::files {

/// One constant load from rest at t = 0, rising in time.
struct LoadCase {
  std::string name = {};
  double power_start = unset, power_end = unset;  ///< [W]; NaN: the power at its speed
  double speed = unset;                           ///< [rad/s]; NaN: only its power is known
  double at_once = 0.0;                           ///< displacement at t = 0 [m]
  std::vector<double> time = {};                  ///< [s]
  std::vector<double> displacement = {};          ///< after subtracting at_once [m]
  text::Place place = {};                         ///< place of its first row
};

/// Reads a CSV with time_s, axial_displacement_um, and power_W or speed_rpm or both. Names with
/// other units are allowed ("time_min", "axial_displacement [mm]"). A column load_case separates
/// loads of equal size. Without it the rows of one power are a case; without power, the rows of one
/// speed. The rows may be in any order, at any times.
///
/// Throws InputError for a missing column, a cell that is no number, a time below 0 or twice in a
/// case, and a speed that changes within a case.
[[nodiscard]] std::vector<LoadCase> read_load_cases(const std::string& path);

/// Parses load cases from text; `source` is the name in messages.
[[nodiscard]] std::vector<LoadCase> parse_load_cases(std::string text, const std::string& source);

/// Units of two columns without a header.
struct HistoryUnits {
  double time = 1.0, length = um;
};
/// Parses "s,um", "min,mm" or "s,m". Throws InputError that names `flag`.
[[nodiscard]] HistoryUnits history_units(std::string_view text, const std::string& flag);

/// Reads one load case from a time history of two columns, time and displacement, as ANSYS (PRVAR),
/// CalculiX or a spreadsheet write them: separated by blanks, tabs, commas or semicolons. Lines
/// that begin with a word are skipped. `given` is the load and the file: "50W=a.csv",
/// "6000rpm=b.txt".
///
/// Throws InputError if the load is missing, or no power and no speed; for rows with one number or
/// three; and for a time or a displacement that is not finite or out of range.
[[nodiscard]] LoadCase read_history(const std::string& given, const HistoryUnits& units);

/// Fits a step response to each case. A case without a power keeps none. Throws InputError for a
/// case that cannot be fitted.
[[nodiscard]] std::vector<spindle::StepResponse> fit_load_cases(const std::vector<LoadCase>& cases);

}  // namespace raceway::files
