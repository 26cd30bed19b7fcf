#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/units.h"

namespace raceway::io {

/// A key of model files, as their readers ask for it.
struct ModelKey {
  std::string table;  ///< "bearing", "correction.channel"; a part in capitals is one's own name
  std::string name;   ///< with its unit; a part in capitals is one's own, or one of several units
  std::string unit;   ///< "" of what has none
  double lower = unset, upper = unset;  ///< closed, in `unit`; NaN of what is no number
  bool whole = false;                   ///< a whole number
  bool required = false;                ///< wherever its table is
  std::vector<std::string> choices{};   ///< words, where others are none
  std::string fallback{};  ///< the default as messages have it; empty where it has none
  std::string_view meaning{};
};

/// Every key of model files, by table in the order in which they are read. Numbers of effects are
/// in their catalogues. What it says of a key comes from the reader itself, which is watched as it
/// reads models that have all tables.
[[nodiscard]] std::vector<ModelKey> model_keys();

/// `keys [{table, key, unit, from, to, whole_number, required, choices, default, meaning}]`.
[[nodiscard]] std::string model_keys_json(std::span<const ModelKey> keys);

}  // namespace raceway::io
