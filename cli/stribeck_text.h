#pragma once

#include "friction/stribeck_table.h"
#include "model/model.h"

namespace raceway::cli {

/// Prints a Stribeck table with the speeds as rows and the axial loads as columns, in one block for
/// each radial load and temperature. For cylindrical roller bearings, the radial loads are the
/// columns, and each temperature has one block.
void print_table(const model::Model& model, const friction::StribeckTable& table);

}  // namespace raceway::cli
