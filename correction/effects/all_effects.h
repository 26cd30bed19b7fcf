#pragma once

#include <tuple>

#include "correction/effects/ambient_drift.h"
#include "correction/effects/cooling_switch.h"
#include "correction/effects/exchanged_columns.h"
#include "correction/effects/feed_axis_heat.h"
#include "correction/effects/kinematic_displacement.h"
#include "correction/effects/loose_sensor.h"
#include "correction/effects/motor_heat.h"
#include "correction/effects/offset_jump.h"
#include "correction/effects/recorded_input.h"
#include "correction/effects/second_time_constant.h"
#include "correction/effects/sensor_lag.h"
#include "correction/effects/sensor_quantisation.h"
#include "correction/effects/slow_drift.h"
#include "correction/effects/speed_dependent_time_constant.h"
#include "correction/effects/thermal_asymmetry.h"

namespace raceway::correction {

/// List of the effects of the catalogue, sorted by id. To add an effect, write a header in this
/// folder and add its name here.
using AllEffects = std::tuple<AmbientDrift, CoolingSwitch, ExchangedColumns, FeedAxisHeat,
                              RecordedInput, KinematicDisplacement, LooseSensor, MotorHeat,
                              OffsetJump, SecondTimeConstant, SensorLag, SensorQuantisation,
                              SlowDrift, SpeedDependentTimeConstant, ThermalAsymmetry>;

}  // namespace raceway::correction
