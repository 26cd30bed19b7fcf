#pragma once

#include <span>
#include <vector>

#include "spindle/spindle.h"

namespace raceway::spindle {

/// A run as pictures want it: its rows with the ends of all time steps between them, and the
/// temperatures of all cells at a few times.
struct DrawnRun {
  std::vector<ProfileRow> rows;
  std::vector<Moment> moments;  ///< one for each row
  std::vector<State> states;    ///< rising in time, the state of the highest force among them
};

/// Simulates `run` of `profile` once more, in the same steps. `states`: how many at most, evenly
/// over its time; the last one is where it ended.
[[nodiscard]] DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile,
                                 const State* start, const Run& run, std::size_t states = 12);

/// Adds the early end of a run as its last moment, and as a row of its own to the programme, where
/// it lies behind the last row that was reached. A run that did not end early stays as it is.
void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run);

}  // namespace raceway::spindle
