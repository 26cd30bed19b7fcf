#pragma once

#include <string>
#include <vector>

#include "cli/number_flag.h"
#include "session/operating_point.h"

namespace raceway::cli {

/// Parses the values of a flag: "100,300,900", "0:12000:250" (from:to:step), or both:
/// "0,100:500:100". Throws text::InputError for other texts, for values that are equal or not in
/// ascending order, and for a range that gives more than 1e7 values. The function does not check
/// that the values are within `range`; it passes `range` to ask_about_thousands().
[[nodiscard]] std::vector<double> axis(const std::string& text, const NumberRange& range,
                                       const std::string& flag);

/// Flags `--speed`, `--axial-load`, `--radial-load` and `--temperature` of a command that computes
/// many points.
struct AxisFlags {
  std::string speed, axial_load, radial_load, temperature;

  /// Declares the flags; `speed_help` is the help text of `--speed`.
  void declare(CLI::App& command, const std::string& speed_help);
  /// Returns the values of each flag; empty if a flag is not given.
  [[nodiscard]] session::AskedAxes asked() const;
};

/// Throws text::InputError for the first value outside the range.
void require_all(const std::vector<double>& values, const NumberRange& range,
                 const std::string& flag);

}  // namespace raceway::cli
