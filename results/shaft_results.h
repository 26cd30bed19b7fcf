#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/judgement.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

/// Writes results of a shaft as CSV and JSON, with units in the keys (docs/files.md). Values
/// without an equilibrium are empty or null.
namespace raceway::results {

/// Returns the name of a bearing in column names, `front_1` and so on, counted from the tool.
[[nodiscard]] std::string bearing_place(const bearing::Arrangement& arrangement, std::size_t i);

/// A column of shaft results: its name with unit, and its value in that unit; NaN without an
/// equilibrium.
struct DisplacementColumn {
  std::string name;
  std::function<double(const shaft::ShaftPrediction&)> value;
};

/// Returns the columns of the shaft and of each bearing that displacement_text() writes between
/// speed and status.
[[nodiscard]] std::vector<DisplacementColumn> displacement_columns(
    const bearing::Arrangement& arrangement);

/// Returns the shaft position over speed as CSV: `#` lines with title, version and model text, then
/// the columns speed_rpm, axial_displacement_um, front_force_N, rear_force_N, axial_stiffness_N_um,
/// friction_torque_Nmm, power_loss_W, axial_position_um, the columns of every bearing, the columns
/// of the band and the status. Values have 12 digits. `band` has one row for each point, or is
/// null.
[[nodiscard]] std::string displacement_text(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            std::string_view model_text,
                                            const BandOfResult* band = nullptr);

/// Returns the shaft position over speed as JSON: {"rows": [...]}, with the standstill values
/// before the rows.
[[nodiscard]] std::string displacement_json(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            const BandOfResult* band = nullptr,
                                            const model::Findings& findings = {});

/// Returns the results at one point as a document, with friction and heat of the bearings in full
/// precision.
[[nodiscard]] std::string shaft_solve_json(const model::Model& model,
                                           const shaft::ShaftPoint& point,
                                           const shaft::ShaftPrediction& prediction,
                                           const BandOfResult* band = nullptr,
                                           const model::Findings& findings = {});

}  // namespace raceway::results
