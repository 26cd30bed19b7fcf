#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// Uncertainty of result rows from fitted parameters: half widths of 95 % bands (model::Band), with
/// the names of their columns.
struct BandOfResult {
  std::vector<std::string> parameters;  ///< names of the fitted parameters
  std::vector<std::string> names;       ///< names with unit: "friction_torque_band_Nmm"
  std::vector<double> half_widths;      ///< row by row, in the order of the names [SI]
};

}  // namespace raceway::results
