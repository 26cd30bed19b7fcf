#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "control/plan.h"

/// The writers of a ControlPlan share this.
namespace raceway::control {

/// Letters, digits, blanks and harmless signs; anything else, which could end a comment or a text
/// of the language that it is written into, becomes "_".
[[nodiscard]] std::string harmless(std::string_view text);

/// 15 digits; `endless` where it is infinite or not known.
[[nodiscard]] std::string control_number(double value, std::string_view endless);

/// Joined by ", ", each wrapped in `before` and `after`.
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
/// Those of the table of a power, the one that runs fastest first.
[[nodiscard]] std::vector<TableAxis> axes_of(const ControlPlan& plan, const ControlDrive& power);
/// " at 300 N": the axial load of its table, where no input has it.
[[nodiscard]] std::string fixed_load(const ControlPlan& plan, const ControlDrive& power);

/// Hash of the numbers of a plan; a saved state belongs to the plan with the same stamp.
[[nodiscard]] std::uint32_t stamp(const ControlPlan& plan);

/// The lines that every file begins with: what it is, of which model, and what is not in it. Each
/// begins with `mark`.
[[nodiscard]] std::string control_heading(const ControlPlan& plan, std::string_view mark);
/// The source, a note and a warning in such a line, read back; empty in others.
[[nodiscard]] std::string source_in_heading(std::string_view line, std::string_view mark);
[[nodiscard]] std::string note_in_heading(std::string_view line, std::string_view mark);
[[nodiscard]] std::string warning_in_heading(std::string_view line, std::string_view mark);

/// `text` with every `@KEY@` replaced.
struct Replacement {
  std::string_view key;
  std::string text;
};
[[nodiscard]] std::string filled(std::string_view text, const std::vector<Replacement>& values);

}  // namespace raceway::control
