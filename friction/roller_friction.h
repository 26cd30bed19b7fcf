#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "bearing/roller_equilibrium.h"
#include "friction/friction_law.h"
#include "friction/heat.h"
#include "friction/lubricant.h"
#include "friction/palmgren.h"
#include "friction/skf.h"

namespace raceway::friction {

/// Inputs of the friction laws for cylindrical roller bearings.
struct RollerState {
  const bearing::RollerBearing* bearing = nullptr;
  F1Load counted = F1Load::rollers;    ///< choice of the load F in counted_load()
  double speed = 0.0;                  ///< [rad/s]
  double radial_load = 0.0;            ///< F_r [N], magnitude
  double inner_sum = 0.0;              ///< Σ Qi, sum of roller loads on the inner ring [N]
  double outer_sum = 0.0;              ///< Σ Qo, sum of roller loads on the outer ring [N]
  double kinematic_viscosity = unset;  ///< [m²/s]
};

/// Sum of roller loads divided by radial load, Σ Q/F_r, for straight rollers at zero clearance [1]:
/// integral of cos^(10/9) divided by integral of cos^(19/9), both over half a circle.
inline constexpr double roller_sum_ratio = 1.25803095402823;

/// Load F in the friction laws of roller bearings [N].
///
///   F_r       F = F_r, the external radial load
///   rollers   F = max(F_r, (Σ Qi + Σ Qo)/(2 · 1.25803))
///
/// For straight rollers at zero clearance and at rest, both options give F_r. With the option
/// `rollers`, a preloaded bearing has a load-dependent moment even without external load.
/// Source: derived. The published laws use F_r only.
[[nodiscard]] double counted_load(const RollerState& state);

/// Load-dependent friction moment of a cylindrical roller bearing [N m].
///
///   M1 = f1 F d_m
///
/// F is counted_load(), and d_m is the pitch diameter.
/// Source:   [Palmgren1959; Harris2006, vol. 1, ch. 10], not checked against the books. The value
///           f1 = 0.0003 comes from the public program thermca, after Jungnickel. The usual range
///           of f1 is 0.0002 to 0.0004, without a checked source.
/// Domain:   F >= 0. For roller bearings, f1 is a constant. In Palmgren's law for ball bearings, f1
///           depends on the load.
struct RollerPalmgrenLoad {
  static constexpr std::array parameters{
      Parameter{.name = "f1", .unit = "1", .initial = 0.0003, .lower = 0.0, .upper = 0.01}};
  static double moment(const RollerState& s, double f1);
};

/// Usual factor f0 in the viscous moment of a cylindrical roller bearing [1]. The factor depends on
/// the lubricant supply: grease 0.8, oil-air 1.5, bath 3, jet 6. For an unknown supply, f0 is 1.5.
/// Source: the public program thermca, after Jungnickel.
[[nodiscard]] double usual_roller_f0(std::optional<Supply> supply);

/// Constants of the SKF model for cylindrical roller bearings with a cage, dimension series 10, in
/// units of mm, N, rpm, mm²/s and N mm. The constants were not checked against the catalogue table.
struct SkfRollerConstants {
  double R1 = 1.12e-6;
  double S1 = 0.16;  ///< factor of the axial load F_a; no effect, because F_a = 0 in RollerSkf
  double S2 = 0.0015;
  double K_Z = 5.1;
};

/// Friction moments of the SKF model for cylindrical roller bearings [N m].
///
///   M_rr = φ_ish φ_rs R1 d_m^2.41 F^0.31 (ν n)^0.6
///   M_sl = μ_sl (S1 d_m^0.9 F_a + S2 d_m F),   F_a = 0
///
/// M_rr is the rolling moment and M_sl the sliding moment, in the units of SkfRollerConstants. ν n
/// is the kinematic viscosity times the speed. d_m is the mean of bore and outer diameter, F is
/// counted_load(), and skf.h defines φ and μ_sl. The source of the default mu_EHL = 0.02 was not
/// checked.
/// Source:   the formulas are in SKF, Rolling bearings (catalogue), friction, table 2a. For the
///           constants see SkfRollerConstants. The formulas have no term for centrifugal force.
/// Domain:   speed >= 0, viscosity > 0; bore and outer diameter given.
struct RollerSkf {
  static constexpr std::array parameters{
      SkfSliding::parameters[0],
      Parameter{.name = "mu_EHL", .unit = "1", .initial = 0.02, .lower = 0.005, .upper = 0.2},
      SkfRolling::parameters[0]};
  static double sliding(const RollerState& s, double mu_bl, double mu_EHL);
  static double rolling(const RollerState& s, double K_rs);
};

/// Returns the parameters of a friction law for roller bearings.
[[nodiscard]] std::span<const Parameter> roller_parameters(FrictionLaw law);
/// Returns the friction law for roller bearings with this name in files; nullopt for other names.
[[nodiscard]] std::optional<FrictionLaw> find_roller_law(std::string_view name);

/// Throws std::invalid_argument if the bearing lacks data that the law needs. The SKF law needs
/// bore and outer diameter. The program calls this function once for each model.
void require_data(FrictionLaw law, const bearing::RollerBearing& bearing);

/// Returns the load moment and the viscous moment by a friction law for roller bearings [N m].
[[nodiscard]] BaseMoments<double> roller_moments(FrictionLaw law, const RollerState& state,
                                                 std::span<const double> values);
/// Converts the state of a bearing to the input of the friction laws for roller bearings. Without a
/// converged equilibrium, the sums of roller loads are NaN.
[[nodiscard]] RollerState roller_state(const BearingState<double>& state);

/// Splits the friction power of a cylindrical roller bearing between its rings [W].
///
///   viscous   half for each ring: the rolling speed ω d_m (1 - γ²)/4 is equal at both raceways
///   load      in proportion to Σ Qi and Σ Qo
///
/// γ is the ratio of roller diameter to pitch diameter d_m.
/// Source: the equations of split_heat() for balls, with contact angle zero. If the sums Σ Qi and Σ
///         Qo are zero or NaN, each ring gets half of the load-dependent power. The heat of both
///         rings together equals the power loss to within rounding error.
[[nodiscard]] HeatSplit split_heat(const RollerState& state, const BaseMoments<double>& moments);

/// Heat conductance between the rings through dry rollers at rest [W/K].
///
///   G = Σ 1/(R_i + R_o),   R = ((ln(4 L/b) - 1)/k_ring + ln(2 D/b)/k_roller)/(π L)
///
/// The sum is over the rollers. R is the thermal resistance of one contact, R_i at the inner race
/// and R_o at the outer race [K/W]. b is the half width of the contact under the line load Q/L,
/// with the contact load Q. L and D are the length and the diameter of the roller. k_ring and
/// k_roller are thermal conductivities [W/(m K)]. Rollers that touch only one race do not conduct
/// heat.
/// Source:   derived from two known resistances: of a half space (ring) with a strip heat source,
///           and of a cylinder (roller) with a line heat source.
/// Accuracy: the formula agrees with boundary element results to 1 %. In a running bearing, oil and
///           rolling motion transfer additional heat.
[[nodiscard]] double roller_conductance(const bearing::RollerBearing& bearing,
                                        const bearing::RollerEquilibrium& equilibrium,
                                        double roller_conductivity, double ring_conductivity);

}  // namespace raceway::friction
