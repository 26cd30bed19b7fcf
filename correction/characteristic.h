#pragma once

#include <span>
#include <variant>
#include <vector>

#include "correction/beyond.h"
#include "record/units.h"

namespace raceway::correction {

/// A number that depends on the input x of a delay element, a power or a load: its gain or its time
/// constant [SI]. x is in the unit of its column: W, N.
class Characteristic {
 public:
  struct Line {
    double slope, offset;
  };
  struct Power {
    double factor, exponent;
  };
  /// Straight between its points, x rising; the ends hold outside.
  struct Table {
    std::vector<double> input, value;
  };
  using Form = std::variant<Line, Power, Table>;

  Characteristic(Line line) : form_(line) {}
  Characteristic(Power power) : form_(power) {}
  /// Throws std::invalid_argument: no point, lengths that differ, x that does not rise.
  Characteristic(Table table);

  [[nodiscard]] double operator()(double input) const;
  /// Range around x = 0 in which it is positive: from `lower` on and below `upper`, where it no
  /// longer is; infinite where that is nowhere. A power law has no value below 0.
  [[nodiscard]] Interval positive_within() const;
  [[nodiscard]] const Form& form() const { return form_; }

 private:
  Form form_;
};

}  // namespace raceway::correction
