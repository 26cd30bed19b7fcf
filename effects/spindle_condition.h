#pragma once

#include "record/units.h"

namespace raceway::effects {

/// Changes that effects cause in a spindle: factors and heat sources. The factors of several
/// effects are multiplied, and the sources are added.
struct SpindleCondition {
  double outer_seat_factor = 1.0;  ///< factor on the conductance of the outer seats [1]
  double convection_factor = 1.0;  ///< factor on the free convection of housing and end faces [1]
  /// Factor on the conduction through balls and lubricant [1].
  double bearing_conductance_factor = 1.0;
  /// Factor on the conductance from the flange into the machine [1].
  double flange_conductance_factor = 1.0;
  /// Added heat at 10 000 rpm [W]. Motor and drive heat are proportional to powers of the speed,
  /// with the exponents below; the other sources are proportional to speed.
  double motor_heat = 0.0;  ///< heat into housing and shaft between the sets
  double drive_heat = 0.0;  ///< heat into the shaft behind the last bearing
  /// Heat into the shaft at the nose, between the face of the housing and bearing 1.
  double seal_heat = 0.0;
  double front_bearing_heat = 0.0;  ///< heat into the raceways of the front set
  /// Heat into the raceways of the roller bearing behind the rear set, or of the rear set without
  /// such a roller bearing.
  double rear_bearing_heat = 0.0;
  /// Exponents of the speed for the added motor and drive heat [1].
  double motor_heat_exponent = 1.0, drive_heat_exponent = 1.0;
  /// Conductance of a cooled sleeve that the model lacks [W/K]: from the housing to the coolant at
  /// its inlet temperature, or to the ambient if the model has no coolant.
  double sleeve_conductance = 0.0;
  /// Extent of the cooled sleeve [1]. With 0, the sleeve lies only between the sets. With 1, the
  /// sleeve reaches over the bearings up to the outermost bearing faces.
  double sleeve_reach = 1.0;
  /// Temperature rise of the machine at the flange [K], and its time constant [s].
  double structure_rise = 0.0, structure_time = 3600.0;
  /// Selects the preload that determines the friction [1]: of the cold or of the warm sets. 0 means
  /// the preload that the model selects, and 1 the other preload. Values between interpolate.
  double other_preload_feedback = 0.0;
  [[nodiscard]] bool operator==(const SpindleCondition&) const = default;
};

}  // namespace raceway::effects
