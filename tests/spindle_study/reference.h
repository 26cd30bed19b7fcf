#pragma once

#include <string>
#include <vector>

namespace spindle_study {

/// A figure of the simulator beside that of data/reference/spindle_reference.json.
struct Compared {
  std::string name, unit;
  double own = 0.0, reference = 0.0;
  double tolerance = 0.0;  ///< [1]
  double least = 0.0;      ///< what differs by less is good [unit]
  [[nodiscard]] double deviation() const;
  [[nodiscard]] bool good() const;
};

/// The coupled cases: two steady states, start-ups at five speeds, rises against ambient. The bars
/// are those of the cases: 5 % of displacement, rises, power and heat, 10 % of forces, 6 % for
/// start-ups; heat that is less than 1 % of the whole counts as much as the whole's 0.5 %.
[[nodiscard]] std::vector<Compared> against_reference();

[[nodiscard]] std::string line(const Compared& figure);

}  // namespace spindle_study
