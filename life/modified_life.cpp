#include "life/modified_life.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "life/detail/interpolation.h"
#include "record/units.h"

namespace raceway::life {
namespace {

/// c κ^-p of a_ISO, whose p is that of balls and rollers alike.
double oil_share(double kappa, double thin, double thick) {
  const double k = std::min(kappa, 4.0);
  return k < 0.4   ? thin * std::pow(k, -0.054381)
         : k < 1.0 ? thick * std::pow(k, -0.19087)
                   : thick * std::pow(k, -0.071739);
}

double of_bracket(double bracket, double exponent) {
  constexpr double most = 50.0;
  return bracket > 0.0 ? std::min(0.1 * std::pow(bracket, exponent), most) : most;
}

}  // namespace

double rated_viscosity(double speed, double pitch_diameter) {
  const double n = speed / rpm;
  const double size = std::sqrt(pitch_diameter / mm);
  return (n < 1000.0 ? 45000.0 * std::pow(n, -0.83) : 4500.0 / std::sqrt(n)) / size * mm2_per_s;
}

double viscosity_ratio(double kinematic_viscosity, double speed, double pitch_diameter) {
  return kinematic_viscosity / rated_viscosity(speed, pitch_diameter);
}

double life_modification(double kappa, double fatigue_ratio) {
  if (!(kappa >= 0.1 && fatigue_ratio >= 0.0)) return unset;
  const double oil = oil_share(kappa, 2.2649, 1.9987);
  return of_bracket(1.0 - std::pow(2.5671 - oil, 0.83) * std::cbrt(fatigue_ratio), -9.3);
}

double roller_life_modification(double kappa, double fatigue_ratio) {
  if (!(kappa >= 0.1 && fatigue_ratio >= 0.0)) return unset;
  const double oil = oil_share(kappa, 1.3993, 1.2348);
  return of_bracket(1.0 - (1.5859 - oil) * std::pow(fatigue_ratio, 0.4), -9.185);
}

double reliability_factor(double percent) {
  static constexpr std::array reliability{90.0, 95.0, 96.0, 97.0, 98.0,  99.0,  99.2,
                                          99.4, 99.6, 99.8, 99.9, 99.92, 99.94, 99.95};
  static constexpr std::array factor{1.0,  0.64, 0.55, 0.47,  0.37,  0.25,  0.22,
                                     0.19, 0.16, 0.12, 0.093, 0.087, 0.080, 0.077};
  if (!(percent >= reliability.front() && percent <= reliability.back())) return unset;
  return between(reliability, factor, percent);
}

double life_hours(double million_revolutions, double speed) {
  return million_revolutions * 1e6 / (speed / rpm * 60.0);
}

}  // namespace raceway::life
