#pragma once

#include <span>
#include <vector>

#include "friction/contact/contact_data.h"
#include "model/life_data.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the data that only the contact law uses in [lubricant], [bearing] and [friction], and the
/// table [life]; shared with the reader of models. All functions throw InputError like
/// read_model().
namespace raceway::files {

/// Returns the keys of the contact law in a table. A model with another law may contain these keys.
[[nodiscard]] std::span<const Key> contact_keys(std::string_view table);

/// Returns the key tables of [bearing] and [life].
[[nodiscard]] std::vector<KeyTable> contact_tables();

/// Reads the data of the contact law. `used`: true if the model uses the law `contact`; its
/// defaults are then reported. `supply` was read before.
[[nodiscard]] friction::contact::ContactData read_contact(ModelTables& tables, bool used,
                                                          std::optional<friction::Supply> supply);

/// Returns the keys of the contact law that a file contains.
[[nodiscard]] Names written_contact_keys(const ModelTables& tables);

/// Reads the number of the contact law that belongs to the lubricant.
[[nodiscard]] double lubricant_number(ModelTables& tables, std::string_view name);

[[nodiscard]] model::LifeData read_life(ModelTables& tables);

}  // namespace raceway::files
