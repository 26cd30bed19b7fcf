#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reads the table [arrangement] of a model file.
namespace raceway::files {

/// Values and functions of the model reader that read_shaft() needs.
struct ShaftContext {
  const NamedBearing& base;  ///< bearing of the table [bearing]
  /// Reads a bearing from a table; omitted keys have the values of `base`. The table may also
  /// contain the keys `further`.
  std::function<NamedBearing(const Section& table, Keys further)> read_bearing;
  std::function<void(std::string_view key, const std::string& value)> note_default;
  /// Coefficients of thermal expansion of the shaft and the housing of a spindle [1/K]; NaN for
  /// other models.
  std::pair<double, double> expansions{unset, unset};
};

[[nodiscard]] std::vector<KeyTable> arrangement_tables();

/// Returns the shaft with the bearing sets in `section`. Throws InputError like read_model().
[[nodiscard]] model::Shaft read_shaft(const Section& section, const ShaftContext& context);

}  // namespace raceway::files
