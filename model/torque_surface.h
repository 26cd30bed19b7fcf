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
/// residuals are noise. Its terms are those of a cubic polynomial in ln speed, the load and the
/// temperature, each multiplied by the predicted torque of the row. Each load in
/// `further` adds four terms: its value, its square, and its products with ln speed and with
/// `load`. The recorded preload and each ring temperature add the same kinds of terms if they vary.
[[nodiscard]] fit::Saturation torque_saturation(const record::Record& record, TorqueLoad load,
                                                std::vector<TorqueLoad> further = {});

/// Returns the natural logarithms of the absolute values. Values below a hundredth of the largest
/// value are first raised to this limit, because a row without load or speed has no logarithm.
[[nodiscard]] std::vector<double> logarithm(std::vector<double> values);

/// Returns the channels whose recorded values scatter: the temperature if it varies; otherwise an
/// empty list.
[[nodiscard]] std::vector<const record::Channel*> scattering_temperature(
    const record::Record& record);

}  // namespace raceway::model
