#pragma once

#include <span>
#include <string_view>
#include <tuple>

#include "effects/ball_material.h"
#include "effects/cage_friction.h"
#include "effects/centrifugal_ring_growth.h"
#include "effects/churning.h"
#include "effects/differential_slip.h"
#include "effects/displacement_offset.h"
#include "effects/displacement_temperature_drift.h"
#include "effects/effect.h"
#include "effects/elastic_hysteresis.h"
#include "effects/film_self_heating.h"
#include "effects/grease_churning.h"
#include "effects/gyroscopic_slip.h"
#include "effects/inlet_shear_heating.h"
#include "effects/interference_fit.h"
#include "effects/load_exponent.h"
#include "effects/load_offset.h"
#include "effects/lubricant_drag.h"
#include "effects/misalignment.h"
#include "effects/mixed_lubrication.h"
#include "effects/mounting.h"
#include "effects/replenishment_starvation.h"
#include "effects/rig_viscous_drag.h"
#include "effects/seal_friction.h"
#include "effects/shaft_centrifugal_ring_growth.h"
#include "effects/shaft_contraction.h"
#include "effects/shaft_thermal_preload.h"
#include "effects/shaft_thermal_ring_growth.h"
#include "effects/shear_thinning.h"
#include "effects/spin_friction.h"
#include "effects/thermal_preload.h"
#include "effects/thermal_ring_growth.h"
#include "effects/torque_gain.h"
#include "effects/torque_offset.h"
#include "effects/torque_temperature_drift.h"
#include "effects/torque_time_drift.h"
#include "effects/viscous_exponent.h"
#include "effects/windage.h"

namespace raceway::effects {

/// Every effect there is, where it has two forms one after the other. A new one is its file and its
/// name here. Effects on the lubricant act in this order: the film finds its temperature before
/// shares of the viscous moment are taken.
using Catalogue =
    std::tuple<ViscousExponent, LoadExponent, SpinFriction, DifferentialSlip, ElasticHysteresis,
               GyroscopicSlip, FilmSelfHeating, InletShearHeating, ReplenishmentStarvation,
               ShearThinning, MixedLubrication, SealFriction, LoadOffset, LubricantDrag, Churning,
               Windage, CageFriction, ThermalPreload, ShaftThermalPreload, ThermalRingGrowth,
               ShaftThermalRingGrowth, CentrifugalRingGrowth, ShaftCentrifugalRingGrowth,
               InterferenceFit, Misalignment, BallMaterial, Mounting, ShaftContraction,
               GreaseChurning, TorqueGain, TorqueOffset, TorqueTemperatureDrift, TorqueTimeDrift,
               RigViscousDrag, DisplacementOffset, DisplacementTemperatureDrift>;

/// The catalogue with its types erased, in the order of the list: every id once, in the form for
/// that subject where it has one. What does not belong to the subject is among them, so that it can
/// be named: see Description::belongs_to() and moves().
[[nodiscard]] std::span<const Description> catalogue(Subject subject = Subject::bearing);

/// The effect of that id in catalogue(subject), null if there is none.
[[nodiscard]] const Description* find(std::string_view id, Subject subject = Subject::bearing);

/// All forms of all effects, in the order of the list.
[[nodiscard]] std::span<const Description> all_forms();

}  // namespace raceway::effects
