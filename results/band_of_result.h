#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// Half widths of the 95 % bands of results (model::Band), which come from the uncertainty of
/// fitted parameters.
struct BandOfResult {
  std::vector<std::string> parameters;  ///< names of the fitted parameters
  std::vector<std::string> names;   ///< column names with unit, such as "friction_torque_band_Nmm"
  std::vector<double> half_widths;  ///< for each row, one value for each of `names` [SI]
};

}  // namespace raceway::results
