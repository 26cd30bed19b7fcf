#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raceway::text {

/// Header of a LabVIEW measurement file (LVM). The header gives the time of the first row and the
/// time step. If the column X_Value is empty, the time of each row is computed from these two
/// values.
///
/// Source: NI, "Specification for the LabVIEW Measurement File (.lvm)", version 2: `X0`, `Delta_X`,
/// `Decimal_Separator` and `X_Columns` (One, Multi, No). The code was not checked against the
/// specification.
class LabviewHead {
 public:
  static constexpr std::string_view column = "X_Value";

  /// Reads one line above the row of column names.
  void take(std::string_view line);
  /// Returns the time of a row as text, with the decimal mark of the file; empty if the header
  /// gives no time step.
  [[nodiscard]] std::optional<std::string> time_of(std::size_t row) const;

 private:
  bool is_lvm_ = false;
  char decimal_mark_ = '.';
  std::string begin_ = "0", step_{};
};

}  // namespace raceway::text
