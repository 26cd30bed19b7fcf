#pragma once

#include <span>
#include <variant>
#include <vector>

#include "correction/beyond.h"
#include "record/units.h"

namespace raceway::correction {

/// Gain [m] or time constant [s] of a delay element as a function of its input x. The input is a
/// power in W or a load in N.
class Characteristic {
 public:
  struct Line {
    double slope, offset;
  };
  struct Power {
    double factor, exponent;
  };
  /// Linear interpolation between points with rising x. Below the first and above the last point,
  /// the value is constant.
  struct Table {
    std::vector<double> input, value;
  };
  using Form = std::variant<Line, Power, Table>;

  Characteristic(Line line) : form_(line) {}
  Characteristic(Power power) : form_(power) {}
  /// Throws std::invalid_argument if the table is empty, if the numbers of inputs and values
  /// differ, or if the inputs do not rise.
  Characteristic(Table table);

  [[nodiscard]] double operator()(double input) const;
  /// Returns the range of x around 0 in which the value is positive. The range includes `lower` and
  /// excludes `upper`. A limit is infinite if the value remains positive on that side. The range of
  /// a power law starts at 0. If no range around 0 has positive values, both limits are 0.
  [[nodiscard]] Interval positive_within() const;
  [[nodiscard]] const Form& form() const { return form_; }

 private:
  Form form_;
};

}  // namespace raceway::correction
