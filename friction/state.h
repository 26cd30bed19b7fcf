#pragma once

#include "bearing/bearing.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/roller_equilibrium.h"
#include "record/parameter.h"

namespace raceway::friction {

class Lubricant;
namespace contact {
struct ContactData;
}
struct TorqueTable;

/// Choice of a load in a friction law. For ball bearings, F1Load selects the load in the factor f1
/// = z (load/C0)^y of Palmgren's load moment: the static equivalent load P0 or Palmgren's load F_b.
/// Use the load for which the factor z was published or fitted. For cylindrical roller bearings,
/// F1Load selects the load F of the roller laws RollerPalmgrenLoad and RollerSkf: the external
/// radial load (`F_r`) or the load on the rollers (`rollers`), see counted_load().
enum class F1Load { P0, F_b, F_r, rollers };

/// All inputs of a friction law for one bearing at one operating point. T is double or a type for
/// automatic differentiation. Members that do not depend on a fitted parameter are always double.
template <typename T = double>
struct BearingState {
  const bearing::Bearing* bearing = nullptr;  ///< null if the bearing has cylindrical rollers
  /// Ball equilibrium at this point; null if not computed. A law for which needs_equilibrium() is
  /// true requires this equilibrium.
  const bearing::BearingEquilibrium* equilibrium = nullptr;
  bearing::RaceControl race_control = bearing::RaceControl::outer;
  F1Load f1_load = F1Load::P0;
  /// Oil and contact data for the contact law; other base laws ignore both.
  const Lubricant* lubricant = nullptr;
  const contact::ContactData* contact = nullptr;
  const TorqueTable* table = nullptr;  ///< torque table of the law `table`; unused by other laws
  T speed = T(0.0);                    ///< [rad/s]
  T axial_load = T(0.0);               ///< F_a [N]
  T radial_load = T(0.0);              ///< F_r [N], magnitude
  T temperature = T(kelvin(40));       ///< temperature of the lubricant [K]
  T kinematic_viscosity = T(unset);    ///< viscosity at `temperature` [m²/s]
  /// Cylindrical roller bearing and its equilibrium; both are null for ball bearings. For roller
  /// bearings, `bearing` and `equilibrium` are unused.
  const bearing::RollerBearing* rollers = nullptr;
  const bearing::RollerEquilibrium* roller_equilibrium = nullptr;

  /// Pitch diameter d_m of the ball or roller bearing [m].
  [[nodiscard]] double pitch_diameter() const {
    return rollers ? rollers->geometry().pitch_diameter : bearing->geometry().pitch_diameter;
  }
};

/// Description of a parameter of a friction law: name, unit, start value and bounds. The value
/// comes from the model file or from a fit.
using Parameter = record::NumberCard;

}  // namespace raceway::friction
