#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/units.h"

namespace raceway::record {

/// Description of a parameter of a law or an effect. All values are in `unit`, the unit of the
/// model files.
struct NumberCard {
  std::string_view name;
  std::string_view unit;                                    ///< "1" if dimensionless
  double initial;                                           ///< default value and start of a fit
  double lower, upper;                                      ///< smallest and largest allowed value
  double plausible_lower = lower, plausible_upper = upper;  ///< range seen in practice
  /// Value at which the effect has no influence; NaN for a parameter that only changes the shape of
  /// the effect.
  double neutral = 0.0;
  /// True for a temperature that a fit searches only within the range of the temperatures in the
  /// record.
  bool of_the_record = false;
};

enum class Bound { none, lower, upper };

struct Interval {
  double lower = unset, upper = unset;
};

/// Value and standard uncertainty of a parameter, known from a calculation or another measurement
/// before the fit.
struct Prior {
  double value = unset, std = unset;

  [[nodiscard]] bool is_known() const { return std > 0.0; }
};

/// Parameter of a model before and after a fit. All values are in `unit`.
struct Parameter {
  std::string name;  ///< readable name: "f0", "my-effect.c"
  std::string unit;  ///< "1" if dimensionless
  /// Addresses in the model file: "friction.f0", or "effect.2.c" for the third effect. If one
  /// parameter sets several equal values in the file, it has several addresses.
  std::vector<std::string> addresses{};
  double start = unset;    ///< value in the model file; a fit starts from it
  double value = unset;    ///< fitted value; equal to `start` if the parameter was not fitted
  double initial = unset;  ///< default value of the parameter
  double lower = unset, upper = unset;                      ///< closed bounds
  double plausible_lower = unset, plausible_upper = unset;  ///< range seen in practice
  /// Value at which the effect has no influence; NaN for a parameter that only changes the shape of
  /// the effect.
  double neutral = unset;
  /// True if the predicted readings are a linear function of this parameter while all other
  /// parameters are fixed. If several parameters with this property change, the readings are a
  /// linear function of all of them.
  bool proportional = false;
  double scale = 1.0;  ///< typical size, > 0
  /// Standard error; NaN at a bound, or if the data do not determine the parameter.
  double std = unset;
  Interval interval{};  ///< 95 % interval by profile likelihood; NaN if not requested
  Bound at_bound = Bound::none;
  /// False if the data do not determine the parameter, or cannot separate it from another
  /// parameter.
  bool identifiable = true;
  /// Value and standard uncertainty known before the fit; used only for spindle models and
  /// corrections (Subject::approximates()).
  Prior prior{};
  /// True if the fit does not change the parameter, because the record does not determine it or
  /// cannot separate it from other parameters. The parameter stays at `start`, or at the value of
  /// `prior` for spindle models and corrections.
  bool held = false;
  bool plausible = true;  ///< false if `value` is far outside the range seen in practice
};

/// A value with the name of its parameter.
struct NamedValue {
  std::string name;
  double value = unset;
};

/// Returns a typical size of a parameter: the larger absolute value of `start` and `initial`. If
/// both are 0, the size is 1 % of the range from `lower` to `upper`, or 1 if a bound is infinite. A
/// fit divides the parameter by this size.
[[nodiscard]] double typical_size(double start, double initial, double lower, double upper);

}  // namespace raceway::record
