#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raceway::text {

/// The head of a LabVIEW measurement file (LVM), which has the time of the first row and the step
/// in the place of a column of times.
///
/// Source: NI, "Specification for the LabVIEW Measurement File (.lvm)", version 2: `X0`, `Delta_X`,
/// `Decimal_Separator` and `X_Columns` (One, Multi, No). Not seen in print.
class LabviewHead {
 public:
  static constexpr std::string_view column = "X_Value";

  /// Takes a line above the header.
  void take(std::string_view line);
  /// The time of a row, as the file would have it; nothing where the head does not tell.
  [[nodiscard]] std::optional<std::string> time_of(std::size_t row) const;

 private:
  bool is_lvm_ = false;
  char decimal_mark_ = '.';
  std::string begin_ = "0", step_{};
};

}  // namespace raceway::text
