#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/units.h"

namespace raceway::record {

/// Description of a parameter of a law or an effect. Values are in the unit of the files, given by
/// `unit` and by the ending of `name`.
struct NumberCard {
  std::string_view name;
  std::string_view unit;                                    ///< "1" if dimensionless
  double initial;                                           ///< default value and start of a fit
  double lower, upper;                                      ///< closed bounds for fits and files
  double plausible_lower = lower, plausible_upper = upper;  ///< range seen in practice
  /// Value at which the effect has no influence; NaN for a parameter that only changes the shape of
  /// the effect.
  double neutral = 0.0;
  /// True for a temperature that a fit keeps within the temperatures of the record.
  bool of_the_record = false;
};

enum class Bound { none, lower, upper };

struct Interval {
  double lower = unset, upper = unset;
};

/// Prior knowledge of a parameter from a computation or another measurement, with its standard
/// uncertainty.
struct Prior {
  double value = unset, std = unset;

  [[nodiscard]] bool is_known() const { return std > 0.0; }
};

/// A parameter of a model before and after a fit, in the unit of the files.
struct Parameter {
  std::string name;  ///< readable name: "f0", "my-effect.c"
  std::string unit;  ///< "1" if dimensionless
  /// Addresses in the model file: "friction.f0", or "effect.2.c" for the third effect. A parameter
  /// that represents several equal values has several addresses.
  std::vector<std::string> addresses{};
  double start = unset;                 ///< value in the model and start of a fit
  double value = unset;                 ///< fitted value; the start if not fitted
  double initial = unset;               ///< default value in the law
  double lower = unset, upper = unset;  ///< closed bounds
  double plausible_lower = unset, plausible_upper = unset;  ///< range seen in practice
  double neutral = unset;  ///< value without influence; NaN if it changes only a shape
  /// True if the readings are linear in the parameter while all others are fixed. The readings are
  /// also linear in all such parameters together.
  bool proportional = false;
  double scale = 1.0;   ///< typical size, > 0
  double std = unset;   ///< standard error; NaN at a bound and if the data do not determine it
  Interval interval{};  ///< 95 % interval by profile likelihood, if requested
  Bound at_bound = Bound::none;
  /// False if the data do not determine the parameter, or not separately from another one.
  bool identifiable = true;
  Prior prior{};  ///< prior; used only for models that only approximate
  /// True if the parameter stays at its start because another parameter has the same influence.
  /// Also true if the parameter stays at its prior because the record does not determine the
  /// parameter.
  bool held = false;
  bool plausible = true;  ///< false if the value is too far outside the range seen in practice
};

/// A value with the name of its parameter.
struct NamedValue {
  std::string name;
  double value = unset;
};

/// Returns a typical size of a parameter that starts at `start`. Fits divide the parameter by this
/// size, so that its values are of order one.
[[nodiscard]] double typical_size(double start, double initial, double lower, double upper);

}  // namespace raceway::record
