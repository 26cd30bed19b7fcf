#pragma once

#include "bearing/operating_point.h"
#include "model/prediction.h"

namespace raceway::model {

/// Life of a bearing at one point, by the formulas of life/; NaN where they give no number (a
/// thrust bearing, a film too thin for ISO 281). Times are at the point's speed, infinite at
/// standstill.
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
  /// ISO 281 knows no a_ISO for balls that are not of steel: there `modification` holds for steel
  /// balls and stays out of `modified`, which is NaN.
  bool hybrid = false;
};

/// Life of a bearing whose prediction has its balls or rollers in balance. Loads that the bearing
/// carries, `point`, belong to P; the balance has what speed and rings add. Of a cylindrical
/// roller bearing the equivalent load is P_ref of ISO/TS 16281, by which a_ISO goes, and the
/// modified life is a1 a_ISO L10r.
[[nodiscard]] BearingLife bearing_life(const Model& model, const bearing::OperatingPoint& point,
                                       const FrictionPrediction& prediction);

/// κ and `reference` of bearing_life() alone, which no integral over a contact is needed for.
struct ReferenceLife {
  double viscosity_ratio = unset;  ///< [1]
  double reference = unset;        ///< [s]
};
[[nodiscard]] ReferenceLife reference_life(const Model& model, const bearing::OperatingPoint& point,
                                           const FrictionPrediction& prediction);

}  // namespace raceway::model
