#pragma once

#include <tuple>

#include "effects/ball_material.h"
#include "effects/cage_friction.h"
#include "effects/centrifugal_ring_growth.h"
#include "effects/churning.h"
#include "effects/differential_slip.h"
#include "effects/elastic_hysteresis.h"
#include "effects/film_self_heating.h"
#include "effects/grease_churning.h"
#include "effects/gyroscopic_slip.h"
#include "effects/inlet_shear_heating.h"
#include "effects/interference_fit.h"
#include "effects/load_calibration.h"
#include "effects/load_cell_drift.h"
#include "effects/load_exponent.h"
#include "effects/load_offset.h"
#include "effects/lubricant_drag.h"
#include "effects/misalignment.h"
#include "effects/mixed_lubrication.h"
#include "effects/mounting.h"
#include "effects/oil_card.h"
#include "effects/preload_calibration.h"
#include "effects/preload_growth.h"
#include "effects/replenishment_starvation.h"
#include "effects/rig_viscous_drag.h"
#include "effects/seal_friction.h"
#include "effects/sensor_drift.h"
#include "effects/sensor_gain.h"
#include "effects/sensor_offset.h"
#include "effects/set_preload.h"
#include "effects/shaft_contraction.h"
#include "effects/shear_thinning.h"
#include "effects/spin_friction.h"
#include "effects/spindle_coolant.h"
#include "effects/spindle_factor.h"
#include "effects/spindle_heat.h"
#include "effects/structure_temperature.h"
#include "effects/support_bearings.h"
#include "effects/temperature_sensor.h"
#include "effects/thermal_preload.h"
#include "effects/thermal_ring_growth.h"
#include "effects/torque_course.h"
#include "effects/viscous_exponent.h"
#include "effects/windage.h"

namespace raceway::effects {

/// List of all effects. If an effect has one class for a rig and one for a shaft, the two classes
/// are adjacent. docs/design.md describes how to add an effect. Effects that correct wrong data
/// (Card::datum) come first. Effects on the lubricant are applied in the order of this list.
/// FilmSelfHeating, which changes the film temperature, comes before the effects that multiply the
/// viscous moment by a factor.
using Catalogue = std::tuple<
    LubricantViscosity, ViscositySlope, TemperatureGain, TemperatureOffset, LoadCalibration,
    LoadCellDrift, SetPreload, SupportBearings, TorqueCreep, SpeedHysteresis, PreloadCalibration,
    ViscousExponent, LoadExponent, SpinFriction, DifferentialSlip, ElasticHysteresis,
    GyroscopicSlip, FilmSelfHeating, InletShearHeating, ReplenishmentStarvation, ShearThinning,
    MixedLubrication, SealFriction, LoadOffset, LubricantDrag, Churning, Windage, CageFriction,
    ThermalPreload, ShaftThermalPreload, ThermalRingGrowth, ShaftThermalRingGrowth,
    CentrifugalRingGrowth, ShaftCentrifugalRingGrowth, InterferenceFit, Misalignment, BallMaterial,
    OtherMounting, ShaftContraction, GreaseChurning, SensorGain<torque_gain, Need::torque_standard>,
    SensorOffset<torque_offset>, SensorTemperatureDrift<torque_temperature_drift>,
    SensorTimeDrift<torque_time_drift>, RigViscousDrag, SensorOffset<displacement_offset>,
    SensorTemperatureDrift<displacement_temperature_drift>, SleeveCoolant,
    SpindleFactor<seat_conductance>, SpindleHeat<motor_heat>, SpindleHeat<drive_heat>,
    SpindleFactor<convection_factor>, SpindleFactor<bearing_conductance>, PreloadGrowth,
    StructureTemperature, SpindleFactor<flange_conductance>, SpindleHeat<seal_heat>,
    SpindleHeat<front_bearing_heat>, SpindleHeat<rear_bearing_heat>>;

}  // namespace raceway::effects
