#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reader of the table [arrangement] of a model file; shared with the reader of models.
namespace raceway::files {

/// Data that the reader of [arrangement] needs from the reader of models.
struct ShaftContext {
  const NamedBearing& base;  ///< [bearing]
  /// Reads a table that changes keys of `base`. The table may contain the keys `further`.
  std::function<NamedBearing(const Section& table, Keys further)> read_bearing;
  std::function<void(std::string_view key, const std::string& value)> note_default;
  /// Thermal expansion of the shaft and the housing of a spindle [1/K]; NaN if there is no spindle.
  std::pair<double, double> expansions{unset, unset};
};

[[nodiscard]] std::vector<KeyTable> arrangement_tables();

/// Throws InputError like read_model().
[[nodiscard]] model::Shaft read_shaft(const Section& section, const ShaftContext& context);

}  // namespace raceway::files
