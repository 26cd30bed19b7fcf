#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "bearing/roller_bearing.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// Returns true for the designation of a cylindrical roller bearing, such as N1012, NU 210 or
/// NN3014.
[[nodiscard]] bool names_rollers(std::string_view designation);

/// A cylindrical roller bearing of series N10. Its roller dimensions are estimated, because
/// manufacturers do not publish the roller dimensions of this series.
struct EstimatedRollers {
  std::string designation{};
  bearing::RollerGeometry geometry{};
  /// Published values: diameter E of the outer raceway [m] and load ratings C and C0 [N]. All three
  /// are NaN for a size without published values; the rollers are then estimated from the boundary
  /// dimensions alone.
  double outer_raceway = unset, dynamic_rating = unset, static_rating = unset;

  /// Returns true if published values were used for the estimate.
  [[nodiscard]] bool printed() const { return !std::isnan(outer_raceway); }
};

/// Estimates length L, diameter D_w and number Z of the rollers of a bearing of series N10. Bore d
/// and outer diameter D come from files/boundary_dimensions.h for dimension series 10.
///
///   d_m = (d + D)/2,   L = D_w
///   published sizes   D_w = E - d_m,   Z = C0/(44 (1 - γ) L D_w), rounded
///   other sizes       D_w = 0.485 (D - d)/2, rounded to 0.5 mm,   Z = 0.71 π d_m/D_w, rounded
///
/// γ = D_w/d_m. In the formula with C0, C0 is in N, and lengths are in mm.
///
/// Accuracy: the load rating C calculated with these rollers agrees with the published C within
///           2.1 % for eight of eleven sizes. The calculated C is 5.6 % too high for N1013 and 16 %
///           too low for N1022 and N1024. The estimate does not use the published C.
/// Throws InputError for a series other than N10, and for a size without known boundary dimensions.
[[nodiscard]] EstimatedRollers estimated_rollers(std::string_view designation);

/// Returns the text of a model file with comments and the defaults of the friction law. Every
/// estimated value is marked as estimated. `oil` is the ISO VG grade of the oil.
[[nodiscard]] std::string estimated_model_text(const EstimatedRollers& bearing,
                                               friction::FrictionLaw law,
                                               std::string_view roller_material = "steel",
                                               std::string_view oil = {});

}  // namespace raceway::files
