#include "spindle/drawn_run.h"

#include <algorithm>
#include <cmath>

namespace raceway::spindle {
namespace {

/// The programme with a row where it begins and at the end of each step; inputs hold from the row
/// before.
std::vector<ProfileRow> with_step_ends(std::span<const ProfileRow> profile, double begin,
                                       std::span<const double> step_ends) {
  std::vector<ProfileRow> rows;
  rows.reserve(profile.size() + step_ends.size() + 1);
  if (begin < profile.front().time)
    rows.push_back({.time = begin, .inputs = profile.front().inputs});
  constexpr double same = 1e-6;  // times are written with seven digits
  auto end = step_ends.begin();
  for (const ProfileRow& row : profile) {
    const double near = same * std::abs(row.time);
    for (; end != step_ends.end() && *end < row.time - near; ++end)
      rows.push_back({.time = *end, .inputs = row.inputs});
    while (end != step_ends.end() && *end <= row.time + near) ++end;
    rows.push_back(row);
  }
  return rows;
}

std::vector<double> times_to_keep(const Run& run, double begin, std::size_t count) {
  const double end = run.step_ends.back();
  std::vector<double> times;
  const bool highest = run.time_of_highest_force > begin;
  if (highest) times.push_back(run.time_of_highest_force);
  const std::size_t even = count - (highest ? 1 : 0);
  for (std::size_t k = 1; k <= even; ++k)
    times.push_back(k == even ? end
                              : begin + (end - begin) * static_cast<double>(k) /
                                            static_cast<double>(even));
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

DrawnRun drawn_run(Simulator& simulator, std::span<const ProfileRow> profile, const State* start,
                   const Run& run, std::size_t states) {
  DrawnRun drawn;
  if (run.step_ends.empty()) {
    drawn.moments = run.moments;
    drawn.rows.assign(profile.begin(),
                      profile.begin() + static_cast<std::ptrdiff_t>(run.moments.size()));
    if (!run.end.temperatures.empty()) drawn.states.push_back(run.end);
    return drawn;
  }
  const double begin = start ? start->time : 0.0;
  drawn.rows = with_step_ends(profile, begin, run.step_ends);
  const std::vector<double> keep = times_to_keep(run, begin, states);
  Run again = simulator.simulate(drawn.rows, start, run.step_ends, keep);
  drawn.moments = std::move(again.moments);
  drawn.rows.resize(drawn.moments.size());
  // Steps that were taken back the first time leave their trace in the sixth digit: rows are those
  // of the run itself.
  auto own = run.moments.begin();
  for (Moment& m : drawn.moments)
    if (own != run.moments.end() && own->time == m.time) m = *own++;
  // Two times within one step are one state.
  for (State& state : again.kept)
    if (drawn.states.empty() || state.time > drawn.states.back().time)
      drawn.states.push_back(std::move(state));
  return drawn;
}

void add_end(Simulator& simulator, std::vector<ProfileRow>& profile, const State* start, Run& run) {
  const std::size_t reached = run.moments.size();
  if (run.report.converged() || run.step_ends.empty() || reached >= profile.size() ||
      !(run.step_ends.back() < profile[reached].time) ||
      (reached > 0 && !(run.step_ends.back() > profile[reached - 1].time)))
    return;
  const auto next = profile.begin() + static_cast<std::ptrdiff_t>(reached);
  std::vector<ProfileRow> rows(profile.begin(), next);
  rows.push_back({.time = run.step_ends.back(), .inputs = next->inputs});
  Run again = simulator.simulate(rows, start, run.step_ends);
  if (again.moments.size() != rows.size()) return;
  profile.insert(next, rows.back());
  run.moments.push_back(std::move(again.moments.back()));
  run.has_end = true;
}

}  // namespace raceway::spindle
