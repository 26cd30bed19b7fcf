#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fit/judged.h"
#include "record/record.h"

namespace raceway::model {

/// Load on which a friction torque depends, with its value in each row of a record.
struct TorqueLoad {
  const record::Channel* channel = nullptr;
  fit::Surface::Input input;
};

/// Returns the saturated regression of a friction torque: a regression with so many terms that its
/// residuals are noise. The regression has 15 terms of a cubic polynomial in ln speed, the main
/// load (`load`) and temperature. Each further load (`further`) adds four terms: the load, its
/// square, and its products with ln speed and with the main load. If the recorded preload varies,
/// its logarithm adds four terms in the same way. Each recorded ring temperature that varies also
/// adds four. Every term is multiplied by the predicted torque of the row.
[[nodiscard]] fit::Saturation torque_saturation(const record::Record& record, TorqueLoad load,
                                                std::vector<TorqueLoad> further = {});

/// Returns the natural logarithms of the absolute values. Absolute values below 1 % of the largest
/// absolute value are first set to 1 % of the largest, because the logarithm of zero does not
/// exist.
[[nodiscard]] std::vector<double> logarithm(std::vector<double> values);

/// Returns a list with the temperature channel if the recorded temperature varies; otherwise an
/// empty list. The scatter of a temperature reading adds to the scatter of the residuals.
[[nodiscard]] std::vector<const record::Channel*> scattering_temperature(
    const record::Record& record);

}  // namespace raceway::model
