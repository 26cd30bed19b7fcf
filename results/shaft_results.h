#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/judgement.h"
#include "results/band_of_result.h"
#include "shaft/shaft_prediction.h"

/// Writes results for a shaft on its bearing sets as CSV and JSON. The names of columns and keys
/// contain the units (docs/files.md). If there is no equilibrium, values are empty in CSV and null
/// in JSON.
namespace raceway::results {

/// Returns the name of a bearing in column names, such as `front_1`. In each set, the bearings are
/// numbered from the tool side.
[[nodiscard]] std::string bearing_place(const bearing::Arrangement& arrangement, std::size_t i);

/// Column of the CSV text from displacement_text(). `name` ends with the unit. `value` returns the
/// value in this unit, or NaN without an equilibrium.
struct DisplacementColumn {
  std::string name;
  std::function<double(const shaft::ShaftPrediction&)> value;
};

/// Returns the columns for the shaft and for each bearing that displacement_text() writes after the
/// speed.
[[nodiscard]] std::vector<DisplacementColumn> displacement_columns(
    const bearing::Arrangement& arrangement);

/// Returns the shaft position over speed as CSV. Comment lines give title, version and model text.
/// The columns are speed_rpm, axial_displacement_um, front_force_N, rear_force_N,
/// axial_stiffness_N_um, friction_torque_Nmm, power_loss_W, axial_position_um, the columns of every
/// bearing, the half widths of the 95 % error bands from `band`, and status. Values have 12
/// significant digits. `band` has one row for each point; null means no bands.
[[nodiscard]] std::string displacement_text(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            std::string_view model_text,
                                            const BandOfResult* band = nullptr);

/// Returns the shaft position over speed as JSON. The member `rows` has one entry for each point.
/// The member `arrangement` contains values at standstill: preload, preload displacements, and the
/// external axial loads at which the front set or the rear set becomes unloaded.
[[nodiscard]] std::string displacement_json(const model::Model& model,
                                            std::span<const shaft::ShaftPoint> points,
                                            std::span<const shaft::ShaftPrediction> predictions,
                                            const BandOfResult* band = nullptr,
                                            const model::Findings& findings = {});

/// Returns the results at one operating point as JSON, with the friction and heat of each bearing.
[[nodiscard]] std::string shaft_solve_json(const model::Model& model,
                                           const shaft::ShaftPoint& point,
                                           const shaft::ShaftPrediction& prediction,
                                           const BandOfResult* band = nullptr,
                                           const model::Findings& findings = {});

}  // namespace raceway::results
