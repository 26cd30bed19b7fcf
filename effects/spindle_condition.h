#pragma once

#include "record/units.h"

namespace raceway::effects {

/// Changes of a spindle by effects: factors and sources. Several effects multiply their factors and
/// add their sources.
struct SpindleCondition {
  double outer_seat_factor = 1.0;           ///< on the conductance of the outer seats [1]
  double convection_factor = 1.0;           ///< on free convection of housing and end faces [1]
  double bearing_conductance_factor = 1.0;  ///< on ball and lubricant conduction [1]
  double flange_conductance_factor = 1.0;   ///< on the path into the machine [1]
  /// Heat at 10 000 rpm [W], with the power 1 of the speed.
  double motor_heat = 0.0;  ///< into the housing over the gap between the sets, and the shaft there
  double drive_heat = 0.0;  ///< into the shaft behind the last bearing
  double seal_heat = 0.0;  ///< into the shaft at the nose, between the housing's face and bearing 1
  double front_bearing_heat = 0.0;  ///< into the raceways of the front set
  double rear_bearing_heat = 0.0;   ///< into the raceways of the rear set, or of rollers behind it
  /// Powers of the speed of motor and drive heat [1].
  double motor_heat_exponent = 1.0, drive_heat_exponent = 1.0;
  /// Conductance of a sleeve missing in the model, from the housing to the inlet (else the ambient)
  /// [W/K].
  double sleeve_conductance = 0.0;
  /// Extent of that sleeve: 0 between the sets, 1 over their bearings to the outermost faces [1].
  double sleeve_reach = 1.0;
  /// Rise of the machine at the flange [K], approached with a time constant [s].
  double structure_rise = 0.0, structure_time = 3600.0;
  /// Share of the change from friction with the model's choice of preload to the other choice [1].
  double other_preload_feedback = 0.0;
  [[nodiscard]] bool operator==(const SpindleCondition&) const = default;
};

}  // namespace raceway::effects
