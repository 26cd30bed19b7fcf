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
  std::vector<State> states;    ///< temperatures of all cells at a few times, in order of time
};

/// Repeats a simulation of the speed programme `profile` with the time steps of its result `run`.
/// `states` is the largest number of states in the result; a state contains the temperatures of all
/// cells at one time. One state is near the time of the highest axial force of the front set. The
/// other states are evenly spaced in time up to the end of the run. If `run` has no time steps, the
/// result contains the moments of `run`, and the end state of `run` as the only state.
[[nodiscard]] DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile,
                                 const State* start, const Run& run, std::size_t states = 12);

/// Adds the end point of a simulation that stopped early, between two rows of the profile. `run`
/// gets a last element with the results at the stop, and `profile` gets a row with the time of the
/// stop. If the simulation did not stop between two rows, the function changes nothing.
void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run);

}  // namespace raceway::spindle
