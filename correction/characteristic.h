#pragma once

#include <span>
#include <variant>
#include <vector>

#include "correction/beyond.h"
#include "record/units.h"

namespace raceway::correction {

/// Gain or time constant of a delay element [SI] as a function of the input x, a power or a load. x
/// is in the unit of its column: W or N.
class Characteristic {
 public:
  struct Line {
    double slope, offset;
  };
  struct Power {
    double factor, exponent;
  };
  /// Linear interpolation between points with rising x. Outside the points, the end values are
  /// used.
  struct Table {
    std::vector<double> input, value;
  };
  using Form = std::variant<Line, Power, Table>;

  Characteristic(Line line) : form_(line) {}
  Characteristic(Power power) : form_(power) {}
  /// Throws std::invalid_argument for an empty table, for different lengths, and for values of x
  /// that do not rise.
  Characteristic(Table table);

  [[nodiscard]] double operator()(double input) const;
  /// Returns the range around x = 0 in which the value is positive, including `lower` and excluding
  /// `upper`. A missing limit is infinite. A power law is not defined below 0.
  [[nodiscard]] Interval positive_within() const;
  [[nodiscard]] const Form& form() const { return form_; }

 private:
  Form form_;
};

}  // namespace raceway::correction
