#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/key.h"

namespace raceway::files {

/// A key of model files and the name of its table.
struct ListedKey {
  std::string_view table;  ///< name of the table: see KeyTable
  std::string_view only;   ///< models that may have the table: see KeyTable
  Key key;

  [[nodiscard]] std::string meaning() const;
  /// Returns the default as text: a number, a word in quotes, or a description. The text is empty
  /// if the key has no default.
  [[nodiscard]] std::string fallback() const;
};

/// Returns the tables of the keys in a correction file.
[[nodiscard]] std::vector<KeyTable> correction_tables();

/// Returns all keys of model files, table by table. The parameters of effects are not included.
[[nodiscard]] std::vector<ListedKey> model_keys();

/// Returns the keys as a JSON document, `keys [{table, key, kind, unit, from, to, whole_number,
/// required, choices, default, only, meaning}]`.
[[nodiscard]] std::string model_keys_json(std::span<const ListedKey> keys);

}  // namespace raceway::files
