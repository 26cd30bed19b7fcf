#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/model_keys.h"

/// What the readers of model files ask for, written down; not for other code.
namespace raceway::io {

/// Keys as they are asked for. Readers write into the one that is open on their thread.
class KeyBook {
 public:
  /// Open until it goes.
  KeyBook();
  ~KeyBook();
  KeyBook(const KeyBook&) = delete;
  KeyBook& operator=(const KeyBook&) = delete;

  /// The book that is open, else null.
  [[nodiscard]] static KeyBook* open();

  /// The entry of this key, made where there is none.
  ModelKey& entry(std::string_view table, std::string_view name);
  [[nodiscard]] const std::vector<ModelKey>& keys() const { return keys_; }

 private:
  std::vector<ModelKey> keys_;
};

}  // namespace raceway::io
