#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "friction/friction_law.h"
#include "friction/lubricant.h"
#include "friction/torque_table.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reads the tables [lubricant] and [friction] of a model file. All functions throw InputError like
/// read_model().
namespace raceway::files {

/// Base friction law of a model file, and its parameter values in the order of
/// friction::parameters(law).
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

/// Returns the required keys that [lubricant] lacks and, for the law `palmgren`, also the required
/// keys that [friction] and [bearing] lack.
[[nodiscard]] Names missing_keys_of_friction(const ModelTables& tables);

[[nodiscard]] LubricantOfFile read_lubricant(const ModelTables& tables);

/// Reads [friction]. For a catalogue bearing, the parameters of the law are optional. [friction]
/// may also contain the keys `further`.
[[nodiscard]] LawOfFile read_friction(ModelTables& tables, bool from_catalogue,
                                      const Keys& further = {});

/// Reads [friction] for a cylindrical roller bearing. The table is optional. The default of f0
/// depends on the oil supply.
[[nodiscard]] LawOfFile read_friction_of_rollers(ModelTables& tables,
                                                 std::optional<friction::Supply> supply);

/// Returns the keys of Palmgren's law in the table of a roller bearing on a shaft;
/// read_palmgren_of_rollers() reads them.
[[nodiscard]] Keys palmgren_keys_of_rollers();
[[nodiscard]] LawOfFile read_palmgren_of_rollers(ModelTables& tables, const Section& s,
                                                 std::optional<friction::Supply> supply);

/// Throws InputError if the bearing in `table` lacks a value that the friction law needs.
void require_data(friction::FrictionLaw law, const bearing::Bearing& bearing, const Section& table);

}  // namespace raceway::files
