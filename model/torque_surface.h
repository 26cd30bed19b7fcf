#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fit/judged.h"
#include "record/record.h"

namespace raceway::model {

/// Load on which a torque depends, by row of a record.
struct TorqueLoad {
  const record::Channel* channel = nullptr;
  fit::Surface::Input input;
};

/// Saturation of a friction torque: the torque times a cubic in ln speed, a load and temperature
/// with interactions; of further loads, and of the recorded preload and ring temperatures where
/// they vary, the square and the products with speed and load.
[[nodiscard]] fit::Saturation torque_saturation(const record::Record& record, TorqueLoad load,
                                                std::vector<TorqueLoad> further = {});

/// Logarithm with a floor of a hundredth of the largest, as an unloaded or resting bearing has
/// none.
[[nodiscard]] std::vector<double> logarithm(std::vector<double> values);

/// The temperature where it varies: its recorded values scatter about what they were.
[[nodiscard]] std::vector<const record::Channel*> scattering_temperature(
    const record::Record& record);

}  // namespace raceway::model
