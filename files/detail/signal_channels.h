#pragma once

#include "record/channel.h"

/// Columns of a torque sensor in files of measurements and calibrations. A record in memory does
/// not have these columns, because read_record() converts the signal to a friction torque.
namespace raceway::files {

inline constexpr record::Channel torque_signal{.name = "torque_signal_V",
                                               .variable = "torque_signal",
                                               .words = "torque signal",
                                               .unit = "V",
                                               .lower = -1e6,
                                               .upper = 1e6,
                                               .role = record::Role::measured};
inline constexpr record::Channel torque_signal_deviation{
    .name = "std_V",
    .variable = "std",
    .words = "standard deviation of the torque signal",
    .unit = "V",
    .lower = 1e-12,
    .upper = 1e6,
    .role = record::Role::deviation,
    .of = "torque_signal_V"};

/// Reference torque of a calibration, from weights on an arm or from another sensor.
inline constexpr record::Channel reference_torque{.name = "reference_Nm",
                                                  .variable = "reference",
                                                  .words = "reference torque",
                                                  .unit = "N m",
                                                  .lower = -1e9,
                                                  .upper = 1e9,
                                                  .role = record::Role::measured};
inline constexpr record::Channel calibration_signal{.name = "signal_V",
                                                    .variable = "signal",
                                                    .words = "signal",
                                                    .unit = "V",
                                                    .lower = -1e6,
                                                    .upper = 1e6,
                                                    .role = record::Role::measured};

}  // namespace raceway::files
