#pragma once

namespace raceway::life {

/// Reference viscosity ν1 of a bearing at the speed n, with the pitch diameter d_m [m²/s].
///
///   ν1 = 45000 n^-0.83 d_m^-0.5     n < 1000 rpm
///   ν1 = 4500 n^-0.5 d_m^-0.5       n >= 1000 rpm
///
/// The published formulas have ν1 in mm²/s, n in rpm and d_m in mm; the function converts the
/// units.
/// Source:   [ISO281, eqs. 28, 29], as quoted in two texts, not checked against the printed
///           standard. At 1000 rpm, the two formulas differ by 2.3 %. Diagrams of bearing makers
///           give values that are up to 16 % lower.
/// Domain:   speed > 0; ν1 is infinite at standstill.
[[nodiscard]] double rated_viscosity(double speed, double pitch_diameter);

/// Viscosity ratio κ = ν/ν1 [1]: kinematic viscosity ν divided by ν1 of rated_viscosity().
[[nodiscard]] double viscosity_ratio(double kinematic_viscosity, double speed,
                                     double pitch_diameter);

/// Life modification factor a_ISO of radial ball bearings at the viscosity ratio κ [1].
///
///   a_ISO = 0.1 (1 - (2.5671 - c κ^-p)^0.83 (e_C C_u/P)^(1/3))^-9.3, at most 50
///     0.1 <= κ < 0.4    c = 2.2649, p = 0.054381
///     0.4 <= κ < 1      c = 1.9987, p = 0.19087
///     1 <= κ <= 4       c = 1.9987, p = 0.071739;   κ above 4 is treated as 4
///
/// `fatigue_ratio` = e_C C_u/P. e_C is the contamination factor (0 to 1; 1 means clean), C_u the
/// fatigue load limit, and P the equivalent load.
/// Source:   [ISO281, eqs. 31 to 33], as quoted in two texts, not checked against the printed
///           standard. One public program has p = 0.019087 in the second range of κ. 0.019087 is an
///           error, because with this p, a_ISO has a step at κ = 0.4.
/// Domain:   κ >= 0.1, fatigue_ratio >= 0; the factor is NaN below these limits. The formula is
///           valid for steel bearings only. The standard gives no factor for hybrid bearings;
///           makers use the factor for steel bearings.
[[nodiscard]] double life_modification(double viscosity_ratio, double fatigue_ratio);

/// Life modification factor a_ISO of radial roller bearings at the viscosity ratio κ [1].
/// `fatigue_ratio` is the same ratio e_C C_u/P as in life_modification().
///
///   a_ISO = 0.1 (1 - (1.5859 - c κ^-p) (e_C C_u/P)^0.4)^-9.185, at most 50
///     0.1 <= κ < 0.4    c = 1.3993
///     0.4 <= κ          c = 1.2348;   p as in life_modification()
///
/// Source: [ISO281], as quoted in a text, not checked against the printed standard. The domain is
///         the same as for life_modification().
[[nodiscard]] double roller_life_modification(double viscosity_ratio, double fatigue_ratio);

/// Life factor a1 [1]: life at a given reliability in percent, divided by the life at a reliability
/// of 90 %. a1 is interpolated linearly in a table.
///
/// Source:   [ISO281:2007, table 12]. The values were written without a copy of the standard and
///           not checked.
/// Domain:   90 to 99.95 %. Outside this range, the factor is NaN.
[[nodiscard]] double reliability_factor(double reliability_percent);

/// Converts a life in millions of revolutions to hours at a speed [rad/s]. The life in hours is
/// infinite at standstill.
[[nodiscard]] double life_hours(double million_revolutions, double speed);

}  // namespace raceway::life
