#pragma once

#include <span>
#include <string>
#include <vector>

#include "bearing/bearing.h"
#include "fit/fit_status.h"
#include "record/parameter.h"

namespace raceway::shaft {

/// Catalogue data of a back-to-back pair at one preload class.
struct PairRigidity {
  std::string preload_class;  ///< "L", "M", "S"
  double preload = unset;     ///< axial force on each bearing [N]
  double printed = unset;     ///< axial rigidity of the pair, the tangent 2 dF/dx [N/m]
  double computed = unset;    ///< the same with the fitted conformity [N/m]

  [[nodiscard]] double deviation() const { return computed / printed - 1.0; }
};

/// Conformities of spindle bearings lie here; a fit does not leave it.
inline constexpr double lowest_conformity = 0.505, highest_conformity = 0.56;

struct ConformityFit {
  double conformity = unset;  ///< of both grooves [1]
  double std = unset;         ///< NaN with one class, and at a bound
  record::Bound at_bound = record::Bound::none;
  double rms = unset;  ///< of ln(computed/printed) [1]
  std::vector<PairRigidity> classes;
  fit::FitStatus status = fit::FitStatus::not_run;
};

/// Tangent axial rigidity of a back-to-back pair of equal bearings at rest, rigidly preloaded:
/// twice the rigidity of one bearing at that load [N/m]. NaN without equilibrium.
[[nodiscard]] double pair_rigidity(const bearing::Bearing& bearing, double preload);

/// The groove conformity, one for both races, with which a bearing has the pair rigidities of its
/// catalogue: minimises Σ ln²(computed/printed) within lowest_conformity..highest_conformity. The
/// bearing's own conformities do not matter.
///
/// The rigidity hardly separates the two races, so it defines their common value. This value covers
/// everything that makes the contacts stiffer or softer than here, such as elastic rings.
/// Accuracy: `std` comes from the scatter of the classes (digits printed, and what one conformity
///           cannot explain); it does not cover how the maker computed. A change of the conformity
///           by 0.01 changes the rigidity by 19 % (15 deg) or 12 % (25 deg).
/// Throws std::invalid_argument: no class, a preload or a rigidity that is not positive.
[[nodiscard]] ConformityFit fit_conformity(const bearing::Bearing& bearing,
                                           std::span<const PairRigidity> classes);

}  // namespace raceway::shaft
