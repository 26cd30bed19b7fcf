#pragma once

namespace raceway::life {

/// Reference viscosity of a bearing [m²/s].
///
///   ν1 = 45000 n^-0.83 d_m^-0.5     n < 1000 rpm
///   ν1 = 4500 n^-0.5 d_m^-0.5       n >= 1000 rpm
///
/// The published formulas have ν1 in mm²/s, n in rpm and d_m in mm; the function converts the
/// units.
/// Source:   [ISO281, eqs. 28, 29], as quoted in two texts, not checked against the print. The
///           published formulas differ by 2.3 % at 1000 rpm. Makers' diagrams have values up
///           to 16 % lower.
/// Domain:   speed > 0; ν1 is infinite at standstill.
[[nodiscard]] double rated_viscosity(double speed, double pitch_diameter);

/// Viscosity ratio κ = ν/ν1 [1], with ν1 from rated_viscosity().
[[nodiscard]] double viscosity_ratio(double kinematic_viscosity, double speed,
                                     double pitch_diameter);

/// Life modification factor of radial ball bearings [1].
///
///   a_ISO = 0.1 (1 - (2.5671 - c κ^-p)^0.83 (e_C C_u/P)^(1/3))^-9.3, 50 at most
///     0.1 <= κ < 0.4    c = 2.2649, p = 0.054381
///     0.4 <= κ < 1      c = 1.9987, p = 0.19087
///     1 <= κ <= 4       c = 1.9987, p = 0.071739;   κ above 4 is treated as 4
///
/// `fatigue_ratio` = e_C C_u/P: cleanliness e_C from 0 to 1, times the ratio of fatigue load to
/// equivalent load.
/// Source:   [ISO281, eqs. 31 to 33], as quoted in two texts, not checked against the print. One
///           public program has p = 0.019087 in the second range. This is a misprint, because a_ISO
///           would not be continuous with this p.
/// Domain:   κ >= 0.1, fatigue_ratio >= 0; NaN below. The formula is for steel only. The factor is
///           undefined for hybrid bearings, although makers use the same factor for them.
[[nodiscard]] double life_modification(double viscosity_ratio, double fatigue_ratio);

/// Life modification factor of radial roller bearings [1].
///
///   a_ISO = 0.1 (1 - (1.5859 - c κ^-p) (e_C C_u/P)^0.4)^-9.185, 50 at most
///     0.1 <= κ < 0.4    c = 1.3993;   above: c = 1.2348;   p as for balls
///
/// Source:   [ISO281], as quoted in a text, not checked against the print. Domain: as
///           life_modification().
[[nodiscard]] double roller_life_modification(double viscosity_ratio, double fatigue_ratio);

/// Life factor a1 for a reliability in percent, relative to 90 % [1]. a1 is linear between the
/// values of the table.
///
/// Source:   [ISO281:2007, table 12], from memory; no print or transcript was found for a check.
/// Domain:   90 to 99.95 %; NaN outside.
[[nodiscard]] double reliability_factor(double reliability_percent);

/// Converts a life in millions of revolutions to hours at a speed [rad/s]. The life in hours is
/// infinite at standstill.
[[nodiscard]] double life_hours(double million_revolutions, double speed);

}  // namespace raceway::life
