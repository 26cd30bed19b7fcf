#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/judgement.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

/// Results of a shaft as CSV and as JSON, keys with their units (docs/files.md). What has no
/// balance is empty or null.
namespace raceway::results {

/// `front_1` and so on: the place of a bearing in the names of columns, counted from the tool.
[[nodiscard]] std::string bearing_place(const bearing::Arrangement& arrangement, std::size_t i);

/// A number of a shaft: its column with unit, and its value in that unit, NaN without balance.
struct DisplacementColumn {
  std::string name;
  std::function<double(const shaft::ShaftPrediction&)> value;
};

/// Numbers of the shaft and of each of its bearings, as displacement_text() has them between speed
/// and status.
[[nodiscard]] std::vector<DisplacementColumn> displacement_columns(
    const bearing::Arrangement& arrangement);

/// Shaft position against speed as CSV: `#` lines with title, version and the model's text, then
/// speed_rpm, axial_displacement_um, front_force_N, rear_force_N, axial_stiffness_N_um,
/// friction_torque_Nmm, power_loss_W, columns of every bearing, of the band and the status. 12
/// digits. `band`, of as many rows, may be null.
[[nodiscard]] std::string displacement_text(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            std::string_view model_text,
                                            const BandOfResult* band = nullptr);

/// Shaft position against speed as JSON: {"rows": [...]}, with the standstill values at its head.
[[nodiscard]] std::string displacement_json(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            const BandOfResult* band = nullptr,
                                            const model::Findings& findings = {});

/// One of these rows, with all digits of friction and heat of its bearings.
[[nodiscard]] std::string shaft_solve_json(const model::Model& model,
                                           const shaft::ShaftPoint& point,
                                           const shaft::ShaftPrediction& prediction,
                                           const BandOfResult* band = nullptr,
                                           const model::Findings& findings = {});

}  // namespace raceway::results
