#pragma once

#include <vector>

#include "tests/correction_study/machine.h"
#include "tests/correction_study/random.h"

namespace correction_study {

inline constexpr double hour = 3600.0;  ///< [s]

enum class Profile {
  heat_cool,     ///< hours at one speed, hours at rest, then random steps of an hour
  stairs,        ///< rising and falling speeds of an hour, rests between
  spectrum_30,   ///< random speeds, a new one every half hour, one in four at rest
  spectrum_60,   ///< every hour
  spectrum_120,  ///< every two hours
};

struct PlanWish {
  Profile profile = Profile::spectrum_60;
  double hours = 24.0;
  double sampling = 30.0;      ///< [s]
  double top_speed = 10000.0;  ///< [rpm]
  bool uneven = false;         ///< intervals from 0.6 to 1.4 of the sampling
  bool stops = false;          ///< displacement is read in a stop every 5 minutes, else always
  bool feeds = false;          ///< axes move, independent of the speed
  bool coolant_switches = false;
  int runs = 1;  ///< of equal length, 9 hours apart
};

[[nodiscard]] std::vector<PlannedRow> make_plan(const PlanWish& wish, Random& random);

/// Times at least `apart` from every change of speed [s], one in each of `count` equal parts.
[[nodiscard]] std::vector<double> calm_times(const std::vector<PlannedRow>& plan, int count,
                                             double apart, Random& random);

}  // namespace correction_study
