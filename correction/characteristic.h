#pragma once

#include <span>
#include <variant>
#include <vector>

#include "correction/beyond.h"
#include "record/units.h"

namespace raceway::correction {

/// Gain or time constant of a delay element [SI] as a function of the input x. The input is a power
/// in W or a load in N.
class Characteristic {
 public:
  struct Line {
    double slope, offset;
  };
  struct Power {
    double factor, exponent;
  };
  /// Linear interpolation between points with rising x. Before the first point and after the last
  /// one, the value of that point is used.
  struct Table {
    std::vector<double> input, value;
  };
  using Form = std::variant<Line, Power, Table>;

  Characteristic(Line line) : form_(line) {}
  Characteristic(Power power) : form_(power) {}
  /// Throws std::invalid_argument for an empty table, for different numbers of inputs and
  /// values, and for values of x that do not rise.
  Characteristic(Table table);

  [[nodiscard]] double operator()(double input) const;
  /// Returns the range around x = 0 in which the value is positive, including `lower` and excluding
  /// `upper`. A limit is infinite if the value remains positive on that side. The range of a power
  /// law begins at 0, because the law is not defined below. If the value at 0 is not positive, both
  /// limits are 0.
  [[nodiscard]] Interval positive_within() const;
  [[nodiscard]] const Form& form() const { return form_; }

 private:
  Form form_;
};

}  // namespace raceway::correction
