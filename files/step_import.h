#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spindle/step_response.h"
#include "text/error.h"

/// Imports step responses that another program has computed, such as a finite-element analysis of a
/// spindle.
namespace raceway::files {

/// Displacement of a spindle over time t, after a step from rest to a power or a speed at t = 0.
/// The times are in ascending order.
struct LoadCase {
  std::string name = {};
  /// Power in the first and in the last row of the load case [W]; NaN means that only the speed is
  /// known.
  double power_start = unset, power_end = unset;
  /// Speed after the step [rad/s]; NaN means that only the power is known.
  double speed = unset;
  double at_once = 0.0;                   ///< displacement at t = 0 [m]
  std::vector<double> time = {};          ///< times of the rows [s]
  std::vector<double> displacement = {};  ///< displacement minus `at_once` [m]
  text::Place place = {};                 ///< file and line of the first row
};

/// Reads a CSV file with the columns time_s, axial_displacement_um, and power_W or speed_rpm or
/// both. Names with other units are allowed ("time_min", "axial_displacement [mm]"). The column
/// load_case assigns the rows to load cases. Without this column, all rows with equal power are one
/// load case. Without the columns load_case and power, all rows with equal speed are one load case.
/// The rows may be in any order.
///
/// Throws InputError for a missing column, a cell that is not a number in the allowed range, a time
/// that occurs twice in a case, and a speed that changes within a case.
[[nodiscard]] std::vector<LoadCase> read_load_cases(const std::string& path);

/// Parses load cases from text; `source` is the file name in messages.
[[nodiscard]] std::vector<LoadCase> parse_load_cases(std::string text, const std::string& source);

/// Units of time and displacement in a file without a header. `time` is the number of seconds in
/// one unit of time, `length` the number of metres in one unit of displacement.
struct HistoryUnits {
  double time = 1.0, length = um;
};
/// Parses two units such as "s,um", "min,mm" or "s,m". Throws InputError for other texts. The
/// message names the command-line flag `flag`.
[[nodiscard]] HistoryUnits history_units(std::string_view text, const std::string& flag);

/// Reads one load case from a file with two columns, time and displacement, as ANSYS (PRVAR),
/// CalculiX and spreadsheets write them: with blanks, tabs, commas or semicolons between the
/// numbers. Lines that begin with a word are skipped. `given` is a text with the load (a power or a
/// speed) and the file name: "50W=a.csv", "6000rpm=b.txt".
///
/// Throws InputError if the load is missing or invalid, for rows that do not have two numbers, and
/// for a time or a displacement that is not finite or out of range.
[[nodiscard]] LoadCase read_history(const std::string& given, const HistoryUnits& units);

/// Fits a step response to each load case. If the power of a load case is NaN, the power of the
/// fitted step response is also NaN. Throws InputError for a case that cannot be fitted.
[[nodiscard]] std::vector<spindle::StepResponse> fit_load_cases(const std::vector<LoadCase>& cases);

}  // namespace raceway::files
