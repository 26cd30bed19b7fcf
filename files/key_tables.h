#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/key.h"

namespace raceway::files {

/// A key of model files with its table.
struct ListedKey {
  std::string_view table;  ///< as KeyTable::name
  std::string_view only;   ///< as KeyTable::only
  Key key;

  [[nodiscard]] std::string meaning() const;
  /// Default as text: a number, a word in quotes, or words on its origin; empty without a default.
  [[nodiscard]] std::string fallback() const;
};

/// Tables of the reader in files/correction_file.h.
[[nodiscard]] std::vector<KeyTable> correction_tables();

/// Every key of model files, table by table. Numbers of effects are in their catalogues.
[[nodiscard]] std::vector<ListedKey> model_keys();

/// `keys [{table, key, kind, unit, from, to, whole_number, required, choices, default, only,
/// meaning}]`.
[[nodiscard]] std::string model_keys_json(std::span<const ListedKey> keys);

}  // namespace raceway::files
