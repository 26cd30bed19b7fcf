#pragma once

#include <span>
#include <string>
#include <vector>

#include "friction/stribeck_table.h"
#include "model/model.h"
#include "shaft/shaft_prediction.h"

/// Columns of a table in addition to the torque. A bearing has columns such as contributions to the
/// torque, contact angles and pressures. A shaft has columns for the forces on the bearing sets,
/// columns for every bearing, and the axial displacement as the last column. With
/// Columns::of_states, a ball bearing also has columns for stiffness and ball loads.
namespace raceway::session {

enum class Columns { of_tables, of_states };

[[nodiscard]] std::vector<std::string> table_columns(const model::Model& model,
                                                     Columns which = Columns::of_tables);

/// Computes the columns, the torque and the status of several points and writes them into `out`.
/// Several threads may call the function at the same time.
void fill_table_line(const model::Model& model, std::span<const bearing::OperatingPoint> points,
                     std::span<friction::TablePoint> out, Columns which = Columns::of_tables);

/// fill_state() writes the columns for one operating point of a bearing into `out`.
/// fill_shaft_state() writes the columns for a shaft. The values come from `prediction`, which is
/// already computed.
void fill_state(const model::Model& model, const bearing::OperatingPoint& point,
                const model::FrictionPrediction& prediction, friction::TablePoint& out);
void fill_shaft_state(const model::Model& model, const shaft::ShaftPrediction& prediction,
                      friction::TablePoint& out);

}  // namespace raceway::session
