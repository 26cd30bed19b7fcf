#pragma once

#include <span>
#include <vector>

#include "spindle/spindle.h"

namespace raceway::spindle {

/// A run prepared for plots: its rows, the ends of all time steps between them, and the
/// temperatures of all cells at a few times.
struct DrawnRun {
  std::vector<ProfileRow> rows;
  std::vector<Moment> moments;  ///< one moment for each row
  std::vector<State> states;    ///< in order of time, with the state of the highest front force
};

/// Repeats the simulation `run` of `profile` with the same time steps. `states` is the largest
/// number of states. The states are evenly spaced in time, and the last one is at the end of the
/// run.
[[nodiscard]] DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile,
                                 const State* start, const Run& run, std::size_t states = 12);

/// If a run ended early between two rows of the profile, adds this end as the last moment of the
/// run and as an additional row of the profile. Otherwise the function changes nothing.
void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run);

}  // namespace raceway::spindle
