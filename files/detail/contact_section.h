#pragma once

#include <span>
#include <vector>

#include "friction/contact/contact_data.h"
#include "model/life_data.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the keys of [lubricant], [bearing] and [friction] that only the contact law uses, and the
/// table [life]. All functions throw InputError like read_model().
namespace raceway::files {

/// Returns the keys of the contact law in a table. A model with another law may contain these keys.
[[nodiscard]] std::span<const Key> contact_keys(std::string_view table);

/// Returns two key tables: the keys of [bearing] that only the contact law uses, and [life].
[[nodiscard]] std::vector<KeyTable> contact_tables();

/// Reads the keys of the contact law. `used`: true if the model uses the law `contact`; the
/// defaults are then recorded in `tables`. `supply` is the oil supply of the model.
[[nodiscard]] friction::contact::ContactData read_contact(ModelTables& tables, bool used,
                                                          std::optional<friction::Supply> supply);

/// Returns the keys of the contact law that a file gives in [lubricant] and [bearing].
[[nodiscard]] Names written_contact_keys(const ModelTables& tables);

/// Reads a number in [lubricant] that only the contact law uses.
[[nodiscard]] double lubricant_number(ModelTables& tables, std::string_view name);

[[nodiscard]] model::LifeData read_life(ModelTables& tables);

}  // namespace raceway::files
