#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "bearing/roller_bearing.h"
#include "friction/friction_law.h"

namespace raceway::files {

/// True for a designation of a cylindrical roller bearing: N1012, NU 210, NN3014.
[[nodiscard]] bool names_rollers(std::string_view designation);

/// A cylindrical roller bearing of series N10. Makers do not print its rollers.
struct EstimatedRollers {
  std::string designation{};
  bearing::RollerGeometry geometry{};
  /// Numbers of a maker that the rollers follow from: diameter E of the outer raceway [m], C and C0
  /// [N]. NaN where they follow from the boundary dimensions alone.
  double outer_raceway = unset, dynamic_rating = unset, static_rating = unset;

  [[nodiscard]] bool printed() const { return !std::isnan(outer_raceway); }
};

/// Estimates the rollers of a size of series N10, whose boundary dimensions are of dimension series
/// 10 (files/boundary_dimensions.h).
///
///   d_m = (d + D)/2,   L = D_w
///   printed sizes   D_w = E - d_m,   Z = C0/(44 (1 - γ) L D_w), rounded
///   others          D_w = 0.485 (D - d)/2 to 0.5 mm,   Z = 0.71 π d_m/D_w, rounded
///
/// Accuracy: C by these rollers, which is not used to find them, meets the printed C within 2.1 %
///           for eight of eleven sizes; N1013 5.6 % above, N1022 and N1024 16 % below it.
/// Throws InputError for another series and for a size whose dimensions are not known.
[[nodiscard]] EstimatedRollers estimated_rollers(std::string_view designation);

/// Returns a commented model with the defaults of the law; every estimated key is marked. `oil`:
/// its ISO VG grade.
[[nodiscard]] std::string estimated_model_text(const EstimatedRollers& bearing,
                                               friction::FrictionLaw law,
                                               std::string_view roller_material = "steel",
                                               std::string_view oil = {});

}  // namespace raceway::files
