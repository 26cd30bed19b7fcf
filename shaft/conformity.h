#pragma once

#include <span>
#include <string>
#include <vector>

#include "bearing/bearing.h"
#include "fit/fit_status.h"
#include "record/parameter.h"

namespace raceway::shaft {

/// Axial rigidity of a back-to-back pair in one preload class: catalogue value and fitted value.
struct PairRigidity {
  std::string preload_class;  ///< name of the class, such as "L", "M" or "S"
  double preload = unset;     ///< axial preload force on each bearing [N]
  /// Axial rigidity of the pair in the catalogue: slope of axial force over displacement [N/m].
  double printed = unset;
  double computed = unset;  ///< axial rigidity with the fitted conformity [N/m]

  [[nodiscard]] double deviation() const { return computed / printed - 1.0; }
};

/// Usual range of the groove conformity (groove radius divided by ball diameter) of spindle
/// bearings. fit_conformity() searches only in this range.
inline constexpr double lowest_conformity = 0.505, highest_conformity = 0.56;

struct ConformityFit {
  double conformity = unset;  ///< fitted conformity of both grooves [1]
  /// Standard error of `conformity` [1]; NaN if there is only one preload class, or if the
  /// conformity is at a bound.
  double std = unset;
  record::Bound at_bound = record::Bound::none;
  double rms = unset;  ///< RMS over the preload classes of ln(computed/printed rigidity) [1]
  std::vector<PairRigidity> classes;
  fit::FitStatus status = fit::FitStatus::not_run;
};

/// Returns the axial tangent rigidity of a back-to-back pair of equal bearings at rest with rigid
/// preload: twice the rigidity of one bearing under this preload [N/m]. The result is NaN if the
/// bearing has no equilibrium under this preload.
[[nodiscard]] double pair_rigidity(const bearing::Bearing& bearing, double preload);

/// Fits one groove conformity for both races to the axial rigidities of bearing pairs in a
/// catalogue. The fit minimises Σ ln²(computed/printed rigidity) over the preload classes, with a
/// conformity from lowest_conformity to highest_conformity. The conformities in `bearing` are not
/// used.
///
/// The conformities of inner and outer race change the rigidity in nearly the same way, so the fit
/// can find only one common value. The fitted conformity also compensates for all other differences
/// in stiffness between this model and the catalogue, such as elastic rings.
/// Accuracy: `std` comes from the scatter of the deviations over the preload classes. `std` does
///           not include errors of the method with which the maker calculated the catalogue values.
///           A change of the conformity by 0.01 changes the rigidity by 19 % (contact angle 15 deg)
///           or 12 % (25 deg).
/// Throws std::invalid_argument if `classes` is empty, and for a preload or a printed rigidity that
/// is not positive and finite.
[[nodiscard]] ConformityFit fit_conformity(const bearing::Bearing& bearing,
                                           std::span<const PairRigidity> classes);

}  // namespace raceway::shaft
