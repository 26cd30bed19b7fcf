#pragma once

#include <vector>

#include "record/record.h"
#include "rig/detail/speed_regression.h"

/// Rows of friction torque from the windows of a coast-down.
namespace raceway::rig {

/// One torque [SI].
struct Torque {
  double time, speed, torque, std;
  Block mean;       // of its window
  std::size_t row;  // of the coast-down
};

/// Columns in the order of the table of channels, and the runs that gave a torque.
void fill(const std::vector<Torque>& torques, const record::Record& coast_down,
          record::Record& result);

}  // namespace raceway::rig
