#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "bearing/roller_bearing.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// Returns true for a designation of a cylindrical roller bearing: N1012, NU 210, NN3014.
[[nodiscard]] bool names_rollers(std::string_view designation);

/// A cylindrical roller bearing of series N10. Manufacturers do not print the roller dimensions of
/// this series.
struct EstimatedRollers {
  std::string designation{};
  bearing::RollerGeometry geometry{};
  /// Numbers of the manufacturer from which the rollers are estimated: diameter E of the outer
  /// raceway [m], C and C0 [N]. NaN if the rollers are estimated only from the boundary dimensions.
  double outer_raceway = unset, dynamic_rating = unset, static_rating = unset;

  [[nodiscard]] bool printed() const { return !std::isnan(outer_raceway); }
};

/// Estimates the rollers of a bearing of series N10. The boundary dimensions follow dimension
/// series 10 (files/boundary_dimensions.h).
///
///   d_m = (d + D)/2,   L = D_w
///   printed sizes   D_w = E - d_m,   Z = C0/(44 (1 - γ) L D_w), rounded
///   others          D_w = 0.485 (D - d)/2 to 0.5 mm,   Z = 0.71 π d_m/D_w, rounded
///
/// Accuracy: the rating C of these rollers agrees with the printed C within 2.1 % for eight of
///           eleven sizes. This rating is 5.6 % too high for N1013 and 16 % too low for N1022 and
///           N1024. The estimate does not use the printed C.
/// Throws InputError for another series and for a size with unknown dimensions.
[[nodiscard]] EstimatedRollers estimated_rollers(std::string_view designation);

/// Returns a commented model with the defaults of the law. Every estimated key is marked. `oil` is
/// the ISO VG grade of the oil.
[[nodiscard]] std::string estimated_model_text(const EstimatedRollers& bearing,
                                               friction::FrictionLaw law,
                                               std::string_view roller_material = "steel",
                                               std::string_view oil = {});

}  // namespace raceway::files
