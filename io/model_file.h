#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/free_parameters.h"
#include "fit/model.h"
#include "io/catalogue_file.h"

namespace raceway::io {

/// A model as read from its file.
struct ModelFile {
  fit::Model model;
  std::string source;  ///< file name, for messages
  std::string text;    ///< of the file, to be edited with with_values()
  /// Full name of the row that [bearing] catalogue picked; empty where it picks none.
  std::string catalogue = {};
  /// Every default that was used, e.g. `solver.tilt = "locked" (default)`.
  std::vector<std::string> defaults;
};

/// Reads a TOML model (keys with their units: DESIGN.md, Files) into SI.
///
/// Throws InputError naming file, line, key, value and allowed range: text that is no TOML, unknown
/// and missing keys and tables, wrong types, values out of range, bearings that cannot be, formulas
/// that are none.
[[nodiscard]] ModelFile read_model(const std::string& path);

/// The same from text; `source` stands in messages.
[[nodiscard]] ModelFile parse_model(std::string text, const std::string& source);

/// Where a parameter of the law or of an effect stands in its file, as KeyValue::key.
[[nodiscard]] std::string file_key(const fit::ModelParameter& parameter);

/// The same for any parameter that may be fitted; both grooves for the conformity of both.
[[nodiscard]] std::vector<std::string> file_keys(const fit::ModelParameter& parameter);

/// A new value for a number of a model file, in the unit of its key.
struct KeyValue {
  std::string key;  ///< "friction.f0", or "effect[0].friction_coefficient" for the first [[effect]]
  double value;
  /// Put behind the value in place of the comment there; empty leaves that one. Not written into
  /// tables in braces.
  std::string comment = {};
};

/// The text with these values and nothing else changed: comments, order and blanks are kept. A key
/// that was left to its default is added to its table. The values read back exactly.
/// Throws InputError where the text is no TOML or has no such [[effect]], std::invalid_argument for
/// a value that is not finite.
[[nodiscard]] std::string with_values(std::string_view text, std::span<const KeyValue> changes);

/// The text with this effect as one more [[effect]] at its end; nothing else changed. It reads back
/// as it is. Throws std::invalid_argument for a value that is not finite.
[[nodiscard]] std::string with_effect(std::string_view text, const effects::Effect& effect);

/// A commented model of a catalogue bearing, with every default written out.
[[nodiscard]] std::string new_model_text(const CatalogueBearing& row);

}  // namespace raceway::io
