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

/// Steady states at 6000 rpm with and without coolant. Bars as of the cases: 5 % of displacement,
/// rises, power and heat, 10 % of forces; heat by a way that takes little may also differ by 0.5 %
/// of the whole.
[[nodiscard]] std::vector<Compared> steady_states();
/// Start-ups at five speeds over 4 h, and one with friction by the cold set: 6 %.
[[nodiscard]] std::vector<Compared> start_ups();

[[nodiscard]] std::string line(const Compared& figure);

}  // namespace spindle_study
