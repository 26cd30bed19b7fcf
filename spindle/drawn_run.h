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
  std::vector<State> states;    ///< rising in time; includes the state of the highest force
};

/// Simulates `run` of `profile` once more with equal time steps. `states` is the largest number of
/// states, evenly spaced in time; the last one is at the end of the run.
[[nodiscard]] DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile,
                                 const State* start, const Run& run, std::size_t states = 12);

/// Adds the early end of a run as its last moment. If the end is after the last completed row, it
/// also becomes an additional row of the programme. A run without an early end is unchanged.
void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run);

}  // namespace raceway::spindle
