#pragma once

#include <span>
#include <vector>

#include "spindle/spindle.h"

namespace raceway::spindle {

/// Run prepared for plots: results at all rows and at the ends of all time steps, and the
/// temperatures of all cells at a few times.
struct DrawnRun {
  std::vector<ProfileRow> rows;
  std::vector<Moment> moments;  ///< results, one entry for each element of `rows`
  std::vector<State> states;    ///< in order of time; one state is near the highest front force
};

/// Repeats the simulation `run` of `profile` with the same time steps. `states` is the largest
/// number of states in the result. The states are evenly spaced in time up to the end of the run,
/// except the state near the highest front force. If `run` has no time steps, the result contains
/// the moments of `run` and, as the only state, its end state.
[[nodiscard]] DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile,
                                 const State* start, const Run& run, std::size_t states = 12);

/// Adds the end of a simulation that stopped between two rows of the profile: the results at the
/// stop as the last moment of `run`, and a row at the time of the stop in `profile`. Otherwise the
/// function changes nothing.
void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run);

}  // namespace raceway::spindle
