#include "rig/detail/torque_rows.h"

#include <cstddef>

namespace raceway::rig {
namespace {

template <typename Value>
std::vector<double> column(const std::vector<Torque>& torques, const Value& value) {
  std::vector<double> list;
  list.reserve(torques.size());
  for (const Torque& t : torques) list.push_back(value(t));
  return list;
}

/// Runs that gave a torque.
void add_runs(const std::vector<Torque>& torques, const record::Record& coast_down,
              record::Record& result) {
  std::vector<int> known(coast_down.runs.size(), -1);
  result.set(record::run, column(torques, [&](const Torque& t) {
               const int run = coast_down.run_of(t.row);
               if (run < 0) return -1.0;
               int& place = known.at(static_cast<std::size_t>(run));
               if (place < 0) {
                 place = static_cast<int>(result.runs.size());
                 result.runs.push_back(coast_down.runs[static_cast<std::size_t>(run)]);
               }
               return static_cast<double>(place);
             }));
}

}  // namespace

void fill(const std::vector<Torque>& torques, const record::Record& coast_down,
          record::Record& result) {
  std::size_t c = 0;
  for (const record::Channel& channel : record::channels) {
    if (!channel.is_input()) continue;
    const std::size_t k = c++;
    if (channel == record::speed)
      result.set(channel, column(torques, [](const Torque& t) { return t.speed; }));
    else if (coast_down.has(channel))
      result.set(channel, column(torques, [k](const Torque& t) { return t.mean.inputs[k]; }));
  }
  result.set(record::time, column(torques, [](const Torque& t) { return t.time; }));
  if (coast_down.has(record::run)) add_runs(torques, coast_down, result);
  result.set(record::friction_torque, column(torques, [](const Torque& t) { return t.torque; }));
  result.set(record::torque_deviation, column(torques, [](const Torque& t) { return t.std; }))
      .known = true;
  if (!coast_down.lines.empty())
    for (const Torque& t : torques) result.lines.push_back(coast_down.line(t.row));
}

}  // namespace raceway::rig
