#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// Uncertainty of the rows of a result from fitted parameters: half widths of 95 % bands
/// (model::Band), next to the numbers that they belong to.
struct BandOfResult {
  std::vector<std::string> parameters;  ///< that were fitted
  std::vector<std::string> names;       ///< with unit: "friction_torque_band_Nmm"
  std::vector<double> half_widths;      ///< row by row, each in the order of the names [SI]
};

}  // namespace raceway::results
