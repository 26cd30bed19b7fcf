#pragma once

#include "bearing/operating_point.h"
#include "model/prediction.h"

namespace raceway::model {

/// Life of a bearing at one point, by the formulas of life/. A value is NaN if the formulas do not
/// cover the case (a thrust bearing, or a film too thin for ISO 281). Times are for the speed of
/// the point, and infinite at standstill.
struct BearingLife {
  double load_rating = unset;      ///< dynamic load rating C [N], given or from ISO 281
  double fatigue_load = unset;     ///< fatigue load limit C_u [N], given or from ISO 281
  double equivalent_load = unset;  ///< equivalent load P of the applied loads [N]
  double basic = unset;            ///< basic rating life a1 L10 [s]
  double viscosity_ratio = unset;  ///< κ [1]
  double modification = unset;     ///< life modification factor a_ISO [1]
  double modified = unset;         ///< modified rating life L_nm = a1 a_ISO L10 [s]
  /// Reference rating life a1 L10r of ISO/TS 16281, from the loads of the balls or rollers [s].
  double reference = unset;
  /// Static safety factor [1]: (4.2 GPa/p_max)³ for balls, (4 GPa/p_max)² for rollers, with the
  /// largest contact pressure p_max.
  double static_safety = unset;
  /// True if balls or rollers are of another material than the rings. ISO 281 has no a_ISO for this
  /// case. `modification` is then the value for steel, and `modified` is NaN.
  bool hybrid = false;
};

/// Returns the life of a bearing from a prediction with balls or rollers in equilibrium. P uses the
/// applied loads in `point`. The equilibrium also contains the loads caused by speed and by the
/// growth of the rings. For a cylindrical roller bearing, the equivalent load is P_ref of ISO/TS
/// 16281, which determines a_ISO, and the modified life is a1 a_ISO L10r.
[[nodiscard]] BearingLife bearing_life(const Model& model, const bearing::OperatingPoint& point,
                                       const FrictionPrediction& prediction);

/// The viscosity ratio κ and the reference rating life of bearing_life(). These two values need no
/// integral over a contact.
struct ReferenceLife {
  double viscosity_ratio = unset;  ///< [1]
  double reference = unset;        ///< [s]
};
[[nodiscard]] ReferenceLife reference_life(const Model& model, const bearing::OperatingPoint& point,
                                           const FrictionPrediction& prediction);

}  // namespace raceway::model
