#pragma once

#include <span>
#include <variant>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// A number that depends on a power loss P: the gain or the time constant of a delay element [SI].
class Characteristic {
 public:
  struct Line {
    double slope, offset;
  };
  struct Power {
    double factor, exponent;
  };
  /// Straight between its points, P rising; the ends hold outside.
  struct Table {
    std::vector<double> power, value;
  };
  using Form = std::variant<Line, Power, Table>;

  Characteristic(Line line) : form_(line) {}
  Characteristic(Power power) : form_(power) {}
  /// Throws std::invalid_argument: no point, lengths that differ, P that does not rise.
  Characteristic(Table table);

  /// At P >= 0 [W].
  [[nodiscard]] double operator()(double power) const;
  /// The least P [W] at which it is no longer positive; infinite where that is nowhere.
  [[nodiscard]] double positive_below() const;
  [[nodiscard]] const Form& form() const { return form_; }

 private:
  Form form_;
};

}  // namespace raceway::correction
