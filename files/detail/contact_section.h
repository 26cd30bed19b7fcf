#pragma once

#include <span>
#include <vector>

#include "friction/contact/contact_data.h"
#include "model/life_data.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Data of the contact law in [lubricant], [bearing] and [friction], in addition to the data of
/// every law, and [life]; shared with the reader of models. All throw InputError as read_model()
/// does.
namespace raceway::files {

/// Returns the keys of the contact law in a table. Tables of data may have them with any law.
[[nodiscard]] std::span<const Key> contact_keys(std::string_view table);

/// Tables of [bearing] and [life].
[[nodiscard]] std::vector<KeyTable> contact_tables();

/// `used`: true for the law `contact`, whose defaults are then reported. `supply` is read already.
[[nodiscard]] friction::contact::ContactData read_contact(ModelTables& tables, bool used,
                                                          std::optional<friction::Supply> supply);

/// Returns the keys of the contact law that a file has in its tables of data.
[[nodiscard]] Names written_contact_keys(const ModelTables& tables);

/// Reads the number of the contact law that belongs to the lubricant.
[[nodiscard]] double lubricant_number(ModelTables& tables, std::string_view name);

[[nodiscard]] model::LifeData read_life(ModelTables& tables);

}  // namespace raceway::files
