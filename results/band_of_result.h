#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// How sure the rows of a result are as far as it comes from fitted parameters: half the widths of
/// 95 % bands (model::Band), beside the numbers that they are of.
struct BandOfResult {
  std::vector<std::string> parameters;  ///< that were fitted
  std::vector<std::string> names;       ///< with unit: "friction_torque_band_Nmm"
  std::vector<double> half_widths;      ///< row by row, each in the order of the names [SI]
};

}  // namespace raceway::results
