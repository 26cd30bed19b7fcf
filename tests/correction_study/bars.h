#pragma once

#include <string>
#include <vector>

#include "tests/correction_study/judge.h"

namespace correction_study {

/// A figure of the study and what is asked of it.
struct Bar {
  std::string number, what;
  bool at_least;      ///< the figure should be large
  double must, good;  ///< in the unit of `measured`
  std::string unit;
  double measured;      ///< NaN where no case bears on it
  double lower, upper;  ///< Wilson's interval of 95 % of a share; NaN of other figures
  int cases;

  [[nodiscard]] bool missed() const { return at_least ? measured < must : measured > must; }
  [[nodiscard]] bool is_good() const { return at_least ? measured >= good : measured <= good; }
};

[[nodiscard]] std::vector<Bar> bars(const std::vector<Outcome>& outcomes);

/// Bars as a table.
[[nodiscard]] std::string table(const std::vector<Bar>& bars);

/// One line on an outcome: class and seed, verdict, sets, errors held out.
[[nodiscard]] std::string line(const Outcome& outcome);

/// For each class how often it is right and wrong, and its verdicts.
[[nodiscard]] std::string confusion(const std::vector<Outcome>& outcomes);

}  // namespace correction_study
