#pragma once

#include <functional>
#include <optional>

#include "fit/model.h"
#include "io/catalogue_file.h"
#include "io/model_section.h"

/// The table [arrangement] of a model file; shared with the reader of models, not for other code.
namespace raceway::io {

/// A bearing as a table of the file describes it, and the row of the catalogue that it started
/// from.
struct NamedBearing {
  bearing::Bearing bearing;
  std::string name;
  std::optional<CatalogueBearing> row = {};
};

/// What the reader of models lends to that of its [arrangement].
struct ShaftContext {
  const NamedBearing& base;  ///< [bearing]
  /// Reads a table that changes keys of `base`, with `further` keys allowed.
  std::function<NamedBearing(const Section& table, const Names& further)> read_bearing;
  std::function<void(std::string_view key, const std::string& value)> note_default;
};

/// Throws InputError as read_model() does.
[[nodiscard]] fit::Shaft read_shaft(const Section& section, const ShaftContext& context);

}  // namespace raceway::io
