#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/units.h"

namespace raceway::record {

/// Card of a parameter of a law or an effect. Values are in the unit of the files, given by `unit`
/// and by the ending of `name`.
struct NumberCard {
  std::string_view name;
  std::string_view unit;  ///< "1" where dimensionless
  double initial;         ///< default and start of a fit
  double lower, upper;    ///< bounds of a fit and of what a file may say, closed
  double plausible_lower = lower, plausible_upper = upper;  ///< range met in practice
  /// With this value an effect changes nothing; NaN for a number that only gives it its shape.
  double neutral = 0.0;
  /// A temperature that occurred: a fit keeps it within the temperatures of the record.
  bool of_the_record = false;
};

enum class Bound { none, lower, upper };

struct Interval {
  double lower = unset, upper = unset;
};

/// Knowledge of a number without the record of a fit: what a computation or another measurement
/// gave, and its standard uncertainty.
struct Prior {
  double value = unset, std = unset;

  [[nodiscard]] bool is_known() const { return std > 0.0; }
};

/// A number of a model, before and after a fit, in the unit of the files.
struct Parameter {
  std::string name;  ///< as people write it: "f0", "my-effect.c"
  std::string unit;  ///< "1" where dimensionless
  /// Addresses in the model file: "friction.f0", "effect.2.c" of the third effect. More than one
  /// where a parameter stands for several equal numbers.
  std::vector<std::string> addresses{};
  double start = unset;                 ///< as the model has it, and where a fit begins
  double value = unset;                 ///< fitted value; the start if not fitted
  double initial = unset;               ///< default of its law
  double lower = unset, upper = unset;  ///< closed bounds
  double plausible_lower = unset, plausible_upper = unset;  ///< range met in practice
  double neutral = unset;  ///< with it an effect changes nothing; NaN for a shape
  /// With all others held, readings change in proportion to it; with all of these together too.
  bool proportional = false;
  double scale = 1.0;   ///< typical size, > 0
  double std = unset;   ///< standard error; NaN at a bound and where the data do not fix it
  Interval interval{};  ///< 95 %, by profile likelihood, where it was asked for
  Bound at_bound = Bound::none;
  bool identifiable = true;  ///< false: the data do not fix it, alone or against another one
  Prior prior{};             ///< weighs against the readings of what only approximates
  /// Left at its start, because another parameter does the same, or at its prior, because the
  /// record cannot tell it.
  bool held = false;
  bool plausible = true;  ///< within the range met in practice, widened
};

/// A number of a model by the name of its parameter.
struct NamedValue {
  std::string name;
  double value = unset;
};

/// A typical size of a number that starts at `start`, so that a fit works with numbers of order
/// one.
[[nodiscard]] double typical_size(double start, double initial, double lower, double upper);

}  // namespace raceway::record
