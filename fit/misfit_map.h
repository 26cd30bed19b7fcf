#pragma once

#include <span>
#include <vector>

#include "fit/compare.h"
#include "fit/data_set.h"

namespace raceway::fit {

/// Mean error of the rows that fall in one range of speed and one range of another input.
struct MisfitCell {
  std::size_t across = 0, up = 0;  ///< indices into the axes of the map
  int rows = 0;
  double bias = unset;       ///< mean of prediction minus reading [N m] or [m]
  double sigmas = unset;     ///< bias over its standard error; NaN where the noise is not known
  bool significant = false;  ///< beyond chance at 5 % over the whole map (Bonferroni)
};

/// Where on the plan a model errs, and by how much more than chance.
///
/// The ranges are those of Comparison::where: levels where the data have few, bins of about equally
/// many rows otherwise. `up` is the first of axial load, radial load, preload, temperature and run
/// that varies; with none, and likewise with one speed, that axis has a single range of all rows.
///
///   standard error of the mean of m rows = sqrt(Σ s_i²) / m
///
/// which takes rows as independent: noise that drifts makes cells look more significant than they
/// are.
struct MisfitMap {
  Variable up_variable = Variable::axial_load;
  std::vector<ErrorRange> across;  ///< speed, rising
  std::vector<ErrorRange> up;      ///< rising
  std::vector<MisfitCell> cells;   ///< those with rows, row by row of the map
  double needed_sigmas = unset;    ///< from which a cell is significant
};

/// `std` of each of `comparison.errors` [N m] or [m], NaN where not known. `data` are the rows that
/// the errors point into.
[[nodiscard]] MisfitMap misfit_map(const Comparison& comparison, const DataSet& data,
                                   std::span<const double> std);

}  // namespace raceway::fit
