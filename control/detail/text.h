#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "control/plan.h"

/// Text functions shared by the writers of a ControlPlan.
namespace raceway::control {

/// Returns the text with "_" for every character that could end a comment or a string of the target
/// language.
[[nodiscard]] std::string harmless(std::string_view text);

/// Returns a number as text with 15 digits; `endless` if the number is infinite or NaN.
[[nodiscard]] std::string control_number(double value, std::string_view endless);

/// Returns the numbers as text, separated by ", ". `before` and `after` enclose each number.
[[nodiscard]] std::string control_numbers(const std::vector<double>& values,
                                          std::string_view before = {},
                                          std::string_view after = {});

/// Returns the units of the displacements: "um", "urad" or "um or urad".
[[nodiscard]] std::string units_of(const ControlPlan& plan);

/// Allowed difference between the displacements in the check record, which `raceway correct`
/// predicts, and the displacements of an exported program in double precision [um] or [urad].
inline constexpr const char* control_tolerance = "1e-9";

/// An axis of a friction table whose value an input supplies, in the unit of this input.
struct TableAxis {
  std::size_t input = nowhere;
  std::vector<double> points{};
  bool by_amount = false;
};
/// Returns the axes of a friction table whose values are inputs of the program. `power` is the
/// drive that uses the table. In ControlTable::torque_Nmm, the first axis varies fastest.
[[nodiscard]] std::vector<TableAxis> axes_of(const ControlPlan& plan, const ControlDrive& power);
/// Returns the constant axial load at which the drive `power` reads its friction table, as text
/// such as " at 300 N"; empty if an input supplies the load.
[[nodiscard]] std::string fixed_load(const ControlPlan& plan, const ControlDrive& power);

/// Returns a hash of the numbers of a plan. An exported program accepts a saved state only if the
/// state contains the same hash.
[[nodiscard]] std::uint32_t stamp(const ControlPlan& plan);

/// Returns the header lines of an exported file: raceway version, model file, trust, warnings and
/// notes. Each line begins with `mark`.
[[nodiscard]] std::string control_heading(const ControlPlan& plan, std::string_view mark);
/// Returns the name of the model file from the first header line; empty for other lines.
[[nodiscard]] std::string source_in_heading(std::string_view line, std::string_view mark);
/// Returns the note in a header line; empty for other lines.
[[nodiscard]] std::string note_in_heading(std::string_view line, std::string_view mark);
/// Returns the warning in a header line; empty for other lines.
[[nodiscard]] std::string warning_in_heading(std::string_view line, std::string_view mark);

/// A replacement of `@KEY@` in a text.
struct Replacement {
  std::string_view key;
  std::string text;
};
/// Returns a text in which the replacements are made.
[[nodiscard]] std::string filled(std::string_view text, const std::vector<Replacement>& values);

}  // namespace raceway::control
