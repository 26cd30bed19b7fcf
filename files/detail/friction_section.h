#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "friction/friction_law.h"
#include "friction/lubricant.h"
#include "friction/torque_table.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// [lubricant] and [friction] of a model file; shared with the reader of models. All throw
/// InputError as read_model() does.
namespace raceway::files {

/// A base law and its values in the order of friction::parameters(law).
struct LawOfFile {
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  friction::F1Load f1_load = friction::F1Load::P0;
  std::vector<double> values;
  std::shared_ptr<const friction::TorqueTable> table = nullptr;
};

[[nodiscard]] std::vector<KeyTable> friction_tables();

struct LubricantOfFile {
  friction::Lubricant lubricant;
  std::optional<friction::Supply> supply;
};

/// Keys that [lubricant], [friction] and, for the law, [bearing] must have or must not have.
[[nodiscard]] Names missing_keys_of_friction(const ModelTables& tables);

[[nodiscard]] LubricantOfFile read_lubricant(const ModelTables& tables);

/// Reads [friction]. The values of the law are optional for a bearing of the catalogue. `further`
/// keys are allowed.
[[nodiscard]] LawOfFile read_friction(ModelTables& tables, bool from_catalogue,
                                      const Keys& further = {});

/// Reads [friction] of a bearing with cylindrical rollers. The table is optional. f0 follows from
/// the supply of oil.
[[nodiscard]] LawOfFile read_friction_of_rollers(ModelTables& tables,
                                                 std::optional<friction::Supply> supply);

/// Keys of Palmgren's law in the table of a roller bearing on a shaft, and its reader.
[[nodiscard]] Keys palmgren_keys_of_rollers();
[[nodiscard]] LawOfFile read_palmgren_of_rollers(ModelTables& tables, const Section& s,
                                                 std::optional<friction::Supply> supply);

/// Refuses a bearing, read from `table`, without data that the law needs.
void require_data(friction::FrictionLaw law, const bearing::Bearing& bearing, const Section& table);

}  // namespace raceway::files
