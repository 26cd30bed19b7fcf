#pragma once

#include "record/units.h"

namespace raceway::effects {

/// Changes that effects cause in a spindle. The factors of several effects are multiplied, and the
/// heat sources are added.
struct SpindleCondition {
  double outer_seat_factor = 1.0;  ///< factor on the conductance of the outer seats [1]
  double convection_factor = 1.0;  ///< factor on the free convection of housing and end faces [1]
  /// Factor on the conduction through balls and lubricant [1].
  double bearing_conductance_factor = 1.0;
  /// Factor on the conductance from the flange into the machine [1].
  double flange_conductance_factor = 1.0;
  /// Heat flows added by effects, at 10 000 rpm [W]. The heat of motor and drive is proportional to
  /// a power of the speed (with the exponents below), and the other heat flows are proportional to
  /// the speed.
  double motor_heat = 0.0;  ///< heat into housing and shaft between the sets
  double drive_heat = 0.0;  ///< heat into the shaft behind the last bearing
  /// Heat into the shaft at the nose, between the face of the housing and bearing 1.
  double seal_heat = 0.0;
  double front_bearing_heat = 0.0;  ///< heat into the raceways of the front set
  /// Heat into the raceways of the roller bearing behind the rear set, or into the raceways of the
  /// rear set if there is no roller bearing.
  double rear_bearing_heat = 0.0;
  /// Exponents of the speed for the added motor and drive heat [1].
  double motor_heat_exponent = 1.0, drive_heat_exponent = 1.0;
  /// Conductance of a cooled sleeve that the model does not contain [W/K]. The heat flows from the
  /// housing to the coolant at its inlet temperature, or to the ambient if the model has no
  /// coolant.
  double sleeve_conductance = 0.0;
  /// Axial extent of the cooled sleeve [1]. If the value is 0, the sleeve covers only the space
  /// between the front and the rear set; if it is 1, the sleeve also covers both sets.
  double sleeve_reach = 1.0;
  /// Temperature rise of the machine at the flange after a long time [K], and time constant of this
  /// rise [s].
  double structure_rise = 0.0, structure_time = 3600.0;
  /// Change of the preload with which the friction is calculated [1]. The model selects the preload
  /// of the cold or of the warm bearing sets (model::Spindle::preload_feedback). At 0, the friction
  /// is calculated with the selected preload. At 1, the friction is calculated with the preload of
  /// the other state (warm instead of cold, or cold instead of warm). Between 0 and 1, the friction
  /// is interpolated.
  double other_preload_feedback = 0.0;
  [[nodiscard]] bool operator==(const SpindleCondition&) const = default;
};

}  // namespace raceway::effects
