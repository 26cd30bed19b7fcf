#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "friction/state.h"

namespace raceway::friction {

/// Bearing dimensions d, D and d_m in the SKF model [m]. In all formulas of this header, n is the
/// speed and ν the kinematic viscosity of the oil.
struct RingSize {
  double bore;            ///< bore, d
  double outer_diameter;  ///< diameter of the outer ring, D
  /// d_m of the SKF model: the mean of bore and outer diameter, not the pitch diameter.
  [[nodiscard]] double mean_diameter() const { return 0.5 * (bore + outer_diameter); }
};

/// Constants of the SKF model for one bearing type, in units of mm, N, rpm, mm²/s and N mm.
struct SkfConstants {
  double R1, R2, R3;  ///< constants of the rolling moment
  double S1, S2, S3;  ///< constants of the sliding moment
  double K_Z;         ///< constant of replenishment_factor()
};

/// Constants of single row angular contact ball bearings. Source: [SKFGeneral, p. 91-101, tables 2a
/// to 5].
/// Domain: the bearings of the catalogue have a contact angle of 40 deg (72 BE, 73 BE). The code
///         also uses the constants for spindle bearings of 15 to 25 deg. The source does not cover
///         these small angles: the factors R2 and S2 of the axial load are for 40 deg.
inline constexpr SkfConstants skf_angular_contact{.R1 = 5.03e-7,
                                                  .R2 = 1.97,
                                                  .R3 = 1.90e-12,
                                                  .S1 = 1.30e-2,
                                                  .S2 = 0.68,
                                                  .S3 = 1.91e-12,
                                                  .K_Z = 4.4};

/// Factor of R3 and S3 for the ball material [1]: 0.41 for ceramic balls, 1 for steel balls.
///
/// 0.41 is the ratio of the densities of silicon nitride and steel. Balls with a density below 5000
/// kg/m³ are treated as ceramic.
[[nodiscard]] inline double skf_ball_factor(const bearing::Material& balls) {
  return balls.density < 5000.0 ? 0.41 : 1.0;
}

/// Factor φ_ish that reduces the rolling moment because of inlet shear heating [1].
///
///   φ_ish = 1 / (1 + 1.84e-9 (n d_m)^1.28 ν^0.64)
///
/// The formula is in its published units: n [rpm], d_m [mm], ν [mm²/s].
/// Source: [SKFGeneral, p. 91-101].
/// Domain: speed >= 0, viscosity > 0; the factor is 1 at standstill.
template <typename T>
T inlet_shear_factor(const T& speed, const T& viscosity, double mean_diameter) {
  using std::pow;
  if (speed <= 0.0) return T(1.0);
  const T n_dm = (speed / rpm) * (mean_diameter / mm);
  return 1.0 / (1.0 + 1.84e-9 * pow(n_dm, 1.28) * pow(viscosity / mm2_per_s, 0.64));
}

/// Factor on the rolling moment that accounts for starvation: incomplete replenishment of oil [1].
///
///   φ_rs = exp(-K_rs ν n (d + D) sqrt(K_Z / (2 (D - d))))
///
/// The formula is in its published units: ν [mm²/s], n [rpm], d and D [mm]. K_rs is 3e-8 for an oil
/// bath with low level or an oil jet, and 6e-8 for grease and oil-air.
/// Source: [SKFGeneral, p. 91-101]. Domain: speed >= 0.
template <typename T>
T replenishment_factor(const T& K_rs, const T& speed, const T& viscosity, const RingSize& ring,
                       double K_Z) {
  using std::exp;
  const double d = ring.bore / mm, D = ring.outer_diameter / mm;
  const T nu_n = (viscosity / mm2_per_s) * (speed / rpm);
  return exp(-K_rs * nu_n * ((d + D) * std::sqrt(K_Z / (2.0 * (D - d)))));
}

/// Weight of boundary lubrication in the sliding friction [1]: 1 at standstill, near 0 with a full
/// film.
///
///   φ_bl = exp(-2.6e-8 (ν n)^1.4 d_m)
///
/// The formula is in its published units: ν [mm²/s], n [rpm], d_m [mm].
/// Source: [SKFGeneral, p. 91-101].
/// Domain: speed >= 0.
template <typename T>
T boundary_share(const T& speed, const T& viscosity, double mean_diameter) {
  using std::exp;
  using std::pow;
  if (speed <= 0.0) return T(1.0);
  const T nu_n = (viscosity / mm2_per_s) * (speed / rpm);
  return exp(-2.6e-8 * pow(nu_n, 1.4) * (mean_diameter / mm));
}

/// Friction coefficient of sliding, μ_sl = φ_bl μ_bl + (1 - φ_bl) μ_EHL [1]. φ_bl is the result of
/// boundary_share(). μ_bl is the coefficient of boundary lubrication, μ_EHL the coefficient of a
/// full film.
/// Source: [SKFGeneral, p. 91-101].
template <typename T>
T sliding_coefficient(const T& mu_bl, const T& mu_EHL, const T& share) {
  return share * mu_bl + (1.0 - share) * mu_EHL;
}

/// Rolling friction moment of the SKF model for single row angular contact ball bearings [N m].
///
///   M_rr = φ_ish φ_rs R1 d_m^1.97 (F_r + F_g + R2 F_a)^0.54 (ν n)^0.6,   F_g = R3 d_m^4 n²
///
/// The formula is in its published units: M_rr [N mm], d_m [mm], F [N], ν [mm²/s], n [rpm]. The
/// code converts these units. φ_ish is inlet_shear_factor(), φ_rs is replenishment_factor(), and
/// F_r and F_a are the external loads. F_g accounts for inertia forces of the balls. For
/// ceramic balls, R3 is multiplied by skf_ball_factor().
/// Source:   [SKFGeneral, p. 91-101], constants for 40 deg (skf_angular_contact). Editions of the
///           catalogue since 2013 give other values for some constants.
/// Domain:   speed >= 0, viscosity > 0, contact angle > 0. The moment is zero at standstill, where
///           the formula has an infinite derivative with respect to speed. At standstill, the code
///           returns zero derivatives if T is a type for automatic differentiation.
/// Accuracy: the code agrees with the formula to rounding error; SKF states no accuracy.
struct SkfRolling {
  static constexpr std::string_view id = "skf_rolling";
  static constexpr std::array parameters{
      Parameter{.name = "K_rs", .unit = "1", .initial = 6e-8, .lower = 0.0, .upper = 1e-6}};
  static constexpr std::array<std::string_view, 3> bearing_data{"ball_material", "bore",
                                                                "outer_diameter"};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& K_rs) {
    using std::abs;
    using std::pow;
    const bearing::BearingGeometry& g = s.bearing->geometry();
    const RingSize ring{g.bore, g.outer_diameter};
    const SkfConstants& c = skf_angular_contact;
    const double d_m = ring.mean_diameter() / mm;
    const double R3 = c.R3 * skf_ball_factor(s.bearing->balls());
    const T n = s.speed / rpm;
    const T nu_n = (s.kinematic_viscosity / mm2_per_s) * n;
    const T load = s.radial_load + R3 * (d_m * d_m * d_m * d_m) * n * n + c.R2 * abs(s.axial_load);
    if (nu_n <= 0.0 || load <= 0.0) return T(0.0);
    const T variables = c.R1 * std::pow(d_m, 1.97) * pow(load, 0.54);
    return inlet_shear_factor(s.speed, s.kinematic_viscosity, ring.mean_diameter()) *
           replenishment_factor(K_rs, s.speed, s.kinematic_viscosity, ring, c.K_Z) * variables *
           pow(nu_n, 0.6) * N_mm;
  }
};

/// Sliding friction moment of the SKF model for single row angular contact ball bearings [N m].
///
///   M_sl = μ_sl S1 d_m^0.26 ((F_r + F_g)^(4/3) + S2 F_a^(4/3)),   F_g = S3 d_m^4 n²
///
/// The formula is in its published units: M_sl [N mm], d_m [mm], F [N], n [rpm]. The code converts
/// these units. F_r and F_a are the external loads. F_g accounts for inertia forces of the balls.
/// The usual value of μ_bl is about 0.15. The usual value of μ_EHL is 0.05 with mineral oil, 0.04
/// with synthetic oil and 0.1 with transmission fluid.
/// Source:   [SKFGeneral, p. 91-101], constants for 40 deg (skf_angular_contact).
/// Domain:   speed >= 0, viscosity > 0, contact angle > 0. At standstill, μ_sl is μ_bl.
/// Accuracy: the code agrees with the formula to rounding error; SKF states no accuracy.
struct SkfSliding {
  static constexpr std::string_view id = "skf_sliding";
  static constexpr std::array parameters{
      Parameter{.name = "mu_bl", .unit = "1", .initial = 0.15, .lower = 0.01, .upper = 0.5},
      Parameter{.name = "mu_EHL", .unit = "1", .initial = 0.05, .lower = 0.005, .upper = 0.2}};
  static constexpr std::array<std::string_view, 3> bearing_data = SkfRolling::bearing_data;

  template <typename T>
  static T moment(const BearingState<T>& s, const T& mu_bl, const T& mu_EHL) {
    using std::abs;
    const bearing::BearingGeometry& g = s.bearing->geometry();
    const RingSize ring{g.bore, g.outer_diameter};
    const SkfConstants& c = skf_angular_contact;
    const double d_m = ring.mean_diameter() / mm;
    const double S3 = c.S3 * skf_ball_factor(s.bearing->balls());
    const T n = s.speed / rpm;
    const T radial = s.radial_load + S3 * (d_m * d_m * d_m * d_m) * n * n;
    const T mu = sliding_coefficient(
        mu_bl, mu_EHL, boundary_share(s.speed, s.kinematic_viscosity, ring.mean_diameter()));
    return mu * (c.S1 * std::pow(d_m, 0.26)) *
           (four_thirds_power(radial) + c.S2 * four_thirds_power(T(abs(s.axial_load)))) * N_mm;
  }

 private:
  template <typename T>
  static T four_thirds_power(const T& x) {
    using std::pow;
    if (x <= 0.0) return T(0.0);
    return pow(x, 4.0 / 3.0);
  }
};

}  // namespace raceway::friction
