#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "control/plan.h"

/// Text functions shared by the writers of a ControlPlan.
namespace raceway::control {

/// Keeps letters, digits, blanks and harmless signs. Any other character could end a comment or a
/// text of the target language and becomes "_".
[[nodiscard]] std::string harmless(std::string_view text);

/// Returns 15 digits; `endless` for an infinite or unknown number.
[[nodiscard]] std::string control_number(double value, std::string_view endless);

/// Joins texts by ", ", each wrapped in `before` and `after`.
[[nodiscard]] std::string control_numbers(const std::vector<double>& values,
                                          std::string_view before = {},
                                          std::string_view after = {});

/// Units of the displacements: "um", "urad" or "um or urad".
[[nodiscard]] std::string units_of(const ControlPlan& plan);

/// Tolerance of the check record against `correct`, in double [um] or [urad].
inline constexpr const char* control_tolerance = "1e-9";

/// An axis of a friction table that an input reads, in the unit of that input.
struct TableAxis {
  std::size_t input = nowhere;
  std::vector<double> points{};
  bool by_amount = false;
};
/// Axes of the table of a power, the fastest running first.
[[nodiscard]] std::vector<TableAxis> axes_of(const ControlPlan& plan, const ControlDrive& power);
/// Returns " at 300 N": the axial load of its table, if no input gives it.
[[nodiscard]] std::string fixed_load(const ControlPlan& plan, const ControlDrive& power);

/// Hash of the numbers of a plan. A saved state belongs to the plan with the same stamp.
[[nodiscard]] std::uint32_t stamp(const ControlPlan& plan);

/// Header lines of every file: its kind, its model and the missing parts. Each line begins with
/// `mark`.
[[nodiscard]] std::string control_heading(const ControlPlan& plan, std::string_view mark);
/// Reads the source, a note and a warning from such a line; empty for other lines.
[[nodiscard]] std::string source_in_heading(std::string_view line, std::string_view mark);
[[nodiscard]] std::string note_in_heading(std::string_view line, std::string_view mark);
[[nodiscard]] std::string warning_in_heading(std::string_view line, std::string_view mark);

/// A replacement of `@KEY@` in a text.
struct Replacement {
  std::string_view key;
  std::string text;
};
[[nodiscard]] std::string filled(std::string_view text, const std::vector<Replacement>& values);

}  // namespace raceway::control
