#pragma once

#include <string>
#include <vector>

#include "bearing/operating_point.h"

namespace raceway::fit {

enum class Quantity { friction_torque, axial_displacement };

/// One measured row. Loads and temperature are those of one bearing; what a file did not carry has
/// been filled in from the rig.
struct Row {
  bearing::OperatingPoint point;
  double inner_ring_temperature = unset;  ///< [K], NaN where not measured
  double outer_ring_temperature = unset;  ///< [K]
  double preload = unset;                 ///< [N]
  double time = unset;                    ///< [s]
  double measured = unset;                ///< friction torque of the rig [N m] or displacement [m]
  double std = unset;                     ///< declared standard deviation of `measured`
  int run = -1;                           ///< index into DataSet::runs, -1 without run_id
  int line = 0;                           ///< where it stands in the file, for messages
};

/// Where the standard deviations of the rows come from. `repeats` is never read from a file: it is
/// what estimate_noise() answers when equal operating points were measured more than once.
enum class NoiseSource { none, declared, regression, repeats };

struct DataSet {
  std::string source;  ///< file name, for messages
  Quantity quantity = Quantity::friction_torque;
  NoiseSource noise = NoiseSource::none;
  std::vector<Row> rows;
  std::vector<std::string> runs;   ///< run_id values in order of appearance
  std::vector<std::string> notes;  ///< what the reader did that the user should know, one line each
};

/// A speed record of a shaft that coasts down, as read: not yet a torque.
struct CoastDownSample {
  double time = unset;   ///< [s]
  double speed = unset;  ///< [rad/s]
  int run = -1;
  int line = 0;
  bearing::OperatingPoint point;  ///< loads and temperature of the row; speed as above
};

struct CoastDownRecord {
  std::string source;
  std::vector<CoastDownSample> samples;
  std::vector<std::string> runs;
  std::vector<std::string> notes;
};

}  // namespace raceway::fit
