#pragma once

#include <span>
#include <string_view>

/// What the keys of model files mean; for io/model_keys.h, not for other code.
namespace raceway::io {

struct KeyMeaning {
  std::string_view table, name;  ///< as in ModelKey
  std::string_view meaning;
};

/// One for each key, by table.
[[nodiscard]] std::span<const KeyMeaning> key_meanings();

}  // namespace raceway::io
