#pragma once

#include "bearing/bearing_equilibrium.h"
#include "bearing/operating_point.h"
#include "model/model.h"

namespace raceway::model {

/// How long a bearing lasts at one point, by the formulas of life/; what has no number there is NaN
/// here (a thrust bearing, a film too thin for ISO 281). Times count at the point's speed, infinite
/// at standstill.
struct BearingLife {
  double load_rating = unset;      ///< C [N], given or of ISO 281
  double fatigue_load = unset;     ///< C_u [N], likewise
  double equivalent_load = unset;  ///< P of the applied loads [N]
  double basic = unset;            ///< a1 L10 [s]
  double viscosity_ratio = unset;  ///< κ [1]
  double modification = unset;     ///< a_ISO [1]
  double modified = unset;         ///< L_nm = a1 a_ISO L10 [s]
  double reference = unset;        ///< a1 L10r of ISO/TS 16281 from the loads of the balls [s]
  double static_safety = unset;    ///< (4.2 GPa/p_max)³ [1]
  /// ISO 281 knows no a_ISO for balls that are not of steel: there `modification` is that of steel
  /// balls and stays out of `modified`, which is NaN.
  bool hybrid = false;
};

/// `bearing`: the one whose balls are in that balance. `viscosity` of the film [m²/s]. Loads that
/// the bearing carries, `point`, are those of P; the balance has what speed and rings add.
[[nodiscard]] BearingLife bearing_life(const LifeData& data, const bearing::Bearing& bearing,
                                       const bearing::OperatingPoint& point,
                                       const bearing::BearingEquilibrium& equilibrium,
                                       double viscosity);

}  // namespace raceway::model
