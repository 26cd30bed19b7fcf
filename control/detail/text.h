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

/// Returns a number with 15 digits; `endless` for an infinite or unknown number.
[[nodiscard]] std::string control_number(double value, std::string_view endless);

/// Returns the numbers with ", " between them. `before` and `after` enclose each number.
[[nodiscard]] std::string control_numbers(const std::vector<double>& values,
                                          std::string_view before = {},
                                          std::string_view after = {});

/// Returns the units of the displacements: "um", "urad" or "um or urad".
[[nodiscard]] std::string units_of(const ControlPlan& plan);

/// Allowed difference between program and `correct` on the check record, in double precision [um]
/// or [urad].
inline constexpr const char* control_tolerance = "1e-9";

/// An axis of a friction table that an input reads, in the unit of that input.
struct TableAxis {
  std::size_t input = nowhere;
  std::vector<double> points{};
  bool by_amount = false;
};
/// Returns the axes of the table of a power. The first axis varies fastest.
[[nodiscard]] std::vector<TableAxis> axes_of(const ControlPlan& plan, const ControlDrive& power);
/// Returns the axial load of the table of a power as text, such as " at 300 N", if no input gives
/// this load.
[[nodiscard]] std::string fixed_load(const ControlPlan& plan, const ControlDrive& power);

/// Returns a hash of the numbers of a plan. A saved state belongs to the plan with the same stamp.
[[nodiscard]] std::uint32_t stamp(const ControlPlan& plan);

/// Returns the header lines of an exported file: kind of file, model and missing parts. Each line
/// begins with `mark`.
[[nodiscard]] std::string control_heading(const ControlPlan& plan, std::string_view mark);
/// Return the source, a note or a warning from a header line; empty for other lines.
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
