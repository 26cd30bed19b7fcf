#pragma once

#include <span>
#include <string>
#include <vector>

#include "friction/stribeck_table.h"
#include "model/model.h"
#include "shaft/shaft_prediction.h"

/// Columns of a table in addition to the torque. A bearing has columns for moments, contact angles,
/// pressures and others. A shaft has these columns for every bearing, and the axial position as the
/// last column. With Columns::of_states, a bearing also has columns for stiffness and ball loads.
namespace raceway::session {

enum class Columns { of_tables, of_states };

[[nodiscard]] std::vector<std::string> table_columns(const model::Model& model,
                                                     Columns which = Columns::of_tables);

/// Computes the columns, the torque and the status of several points and writes them into `out`.
/// Several threads may call the function at the same time.
void fill_table_line(const model::Model& model, std::span<const bearing::OperatingPoint> points,
                     std::span<friction::TablePoint> out, Columns which = Columns::of_tables);

/// Writes the columns for one operating point of a bearing (fill_state()) or of a shaft
/// (fill_shaft_state()) into `out`, from the prediction at this point.
void fill_state(const model::Model& model, const bearing::OperatingPoint& point,
                const model::FrictionPrediction& prediction, friction::TablePoint& out);
void fill_shaft_state(const model::Model& model, const shaft::ShaftPrediction& prediction,
                      friction::TablePoint& out);

}  // namespace raceway::session
