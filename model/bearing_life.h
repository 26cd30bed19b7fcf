#pragma once

#include "bearing/operating_point.h"
#include "model/prediction.h"

namespace raceway::model {

/// Life of a bearing at one operating point, by the formulas in the folder life/. A value is NaN if
/// the formulas are not valid for the bearing or the operating point, for example a thrust bearing
/// or a film too thin for ISO 281. A life is the running time at the speed of the operating point;
/// at standstill, the life is infinite.
struct BearingLife {
  double load_rating = unset;      ///< dynamic load rating C [N], given or from ISO 281
  double fatigue_load = unset;     ///< fatigue load limit C_u [N], given or from ISO 281
  double equivalent_load = unset;  ///< equivalent load P [N]; see bearing_life()
  double basic = unset;            ///< basic rating life a1 L10 [s]; a1: reliability factor
  double viscosity_ratio = unset;  ///< viscosity ratio κ [1]
  double modification = unset;     ///< life modification factor a_ISO [1]
  double modified = unset;         ///< modified rating life L_nm = a1 a_ISO L10 [s]
  /// Reference rating life a1 L10r of ISO/TS 16281, from the loads of the balls or rollers [s].
  double reference = unset;
  /// Static safety factor [1]: (4.2 GPa/p_max)³ for balls, (4 GPa/p_max)² for rollers, with the
  /// largest contact pressure p_max.
  double static_safety = unset;
  /// True if the balls or rollers and the rings have different materials. ISO 281 gives no a_ISO
  /// for hybrid bearings. For these, `modification` is the value for a steel bearing, and
  /// `modified` is NaN.
  bool hybrid = false;
};

/// Returns the life of a bearing. `prediction` must contain the equilibrium of the balls or
/// rollers. For a ball bearing, the equivalent load P is computed from the applied loads in
/// `point`. The reference life also includes the loads caused by speed and by the growth of the
/// rings. For a cylindrical roller bearing, the equivalent load is P_ref of ISO/TS 16281, a_ISO is
/// computed from P_ref, and the modified life is a1 a_ISO L10r.
[[nodiscard]] BearingLife bearing_life(const Model& model, const bearing::OperatingPoint& point,
                                       const FrictionPrediction& prediction);

/// Viscosity ratio κ and reference rating life: two of the values of BearingLife.
struct ReferenceLife {
  double viscosity_ratio = unset;  ///< [1]
  double reference = unset;        ///< [s]
};
[[nodiscard]] ReferenceLife reference_life(const Model& model, const bearing::OperatingPoint& point,
                                           const FrictionPrediction& prediction);

}  // namespace raceway::model
