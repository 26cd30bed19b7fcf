#pragma once

#include <string>
#include <vector>

namespace raceway::results {

/// Half widths of the 95 % bands of results (model::Band), which come from the uncertainty of
/// fitted parameters.
struct BandOfResult {
  std::vector<std::string> parameters;  ///< names of the fitted parameters
  std::vector<std::string> names;  ///< column names with unit, such as "friction_torque_band_Nmm"
  /// For each row, one value for each of `names`, in SI units. Documents contain the value in the
  /// unit of the name.
  std::vector<double> half_widths;
};

}  // namespace raceway::results
