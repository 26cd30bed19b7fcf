#pragma once

#include <string>
#include <vector>

#include "cli/number_flag.h"
#include "session/operating_point.h"

namespace raceway::cli {

/// Parses the values of a flag: "100,300,900", "0:12000:250" (from:to:step), or both:
/// "0,100:500:100". Throws text::InputError for a text of another form, for values that are not in
/// ascending order, for equal values, and for more than 1e7 values. Does not reject values outside
/// `range`: call require_all() for this check. ask_about_thousands() uses `range` to decide whether
/// 1.200 can mean 1200.
[[nodiscard]] std::vector<double> axis(const std::string& text, const NumberRange& range,
                                       const std::string& flag);

/// Flags `--speed`, `--axial-load`, `--radial-load` and `--temperature` of a command that computes
/// many operating points.
struct AxisFlags {
  std::string speed, axial_load, radial_load, temperature;

  /// Declares the flags; `speed_help` is the help text of `--speed`.
  void declare(CLI::App& command, const std::string& speed_help);
  /// Returns the values of each flag. The list of a flag that is not given is empty.
  [[nodiscard]] session::AskedAxes asked() const;
};

/// Throws text::InputError for the first value outside the range.
void require_all(const std::vector<double>& values, const NumberRange& range,
                 const std::string& flag);

}  // namespace raceway::cli
