#pragma once

#include <vector>

#include "record/record.h"
#include "rig/detail/speed_regression.h"

/// Builds rows of friction torque from the windows of a coast-down.
namespace raceway::rig {

/// One torque with its time and speed [SI].
struct Torque {
  double time, speed, torque, std;
  Block mean;       // mean of its window
  std::size_t row;  // row of the coast-down record
};

/// Writes the torques to the columns of `result`, in the order of record::channels. Also adds the
/// names of the runs that have a torque to `result`.
void fill(const std::vector<Torque>& torques, const record::Record& coast_down,
          record::Record& result);

}  // namespace raceway::rig
