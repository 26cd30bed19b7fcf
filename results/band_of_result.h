#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// Half widths of the 95 % bands around results. The bands contain only the uncertainty of fitted
/// parameters (model::Band).
struct BandOfResult {
  std::vector<std::string> parameters;  ///< names of the fitted parameters
  std::vector<std::string> names;  ///< column names with unit, such as "friction_torque_band_Nmm"
  /// Half widths in SI units, row by row. Each row has one value for each column in `names`. CSV
  /// and JSON contain these values in the units of the column names.
  std::vector<double> half_widths;
};

}  // namespace raceway::results
