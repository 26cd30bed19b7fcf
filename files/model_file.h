#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/catalogue_file.h"
#include "files/column_map.h"
#include "files/named_files.h"
#include "files/used_default.h"
#include "model/model.h"
#include "record/note.h"
#include "rig/torque_sensor.h"

namespace raceway::files {

/// A model read from its file.
struct ModelFile {
  model::Model model;
  std::string source;  ///< file name, for messages
  std::string text;    ///< text of the file; with_values() and with_model() edit it
  /// Full name of the row selected by [bearing] catalogue; empty without one.
  std::string catalogue = {};
  /// Entries on bearings and solver other than defaults and catalogue: keys of [bearing], of
  /// the bearings of an [arrangement] and of [solver].
  std::vector<std::string> written = {};
  /// Every default that was used.
  std::vector<UsedDefault> defaults;
  /// Further notes, one line each, without the file's name.
  std::vector<record::Note> notes = {};
  ColumnMap columns = {};  ///< columns of its measurements
  /// Sensor that measures its torque, if the file names one.
  std::optional<rig::TorqueSensor> sensor = {};
  std::vector<NamedFile> files = {};  ///< files named in it, as read
};

/// Reads a TOML model (keys with their units: raceway keys) into SI.
///
/// Throws InputError naming file, line, key, value and allowed range: invalid TOML, unknown and
/// missing keys and tables, wrong types, values out of range, impossible bearings, invalid
/// formulas.
[[nodiscard]] ModelFile read_model(const std::string& path);

/// As above, from text; `source` is the name in messages, and names of files are relative to it.
/// Files in `held` are not read again.
[[nodiscard]] ModelFile parse_model(std::string text, const std::string& source,
                                    std::vector<NamedFile> held = {});

/// A new value for a number of a model file, in the unit of its key.
struct KeyValue {
  /// An address of record::Parameter: "friction.f0", or "effect.0.friction_coefficient" for the
  /// first [[effect]].
  std::string key;
  double value;
  /// Put behind the value in place of the comment there; empty leaves that one. Not written into
  /// tables in braces.
  std::string comment = {};
};

/// Returns the text with these values; comments, order and blanks are kept. A key with a default is
/// added to its table. The values read back exactly. Throws InputError where the text is no TOML or
/// has no such [[effect]], std::invalid_argument for a value that is not finite.
[[nodiscard]] std::string with_values(std::string_view text, std::span<const KeyValue> changes);

/// Returns the text with this effect added as [[effect]] at its end; nothing else changes. It reads
/// back exactly. Throws std::invalid_argument for a value that is not finite.
[[nodiscard]] std::string with_effect(std::string_view text, const effects::Effect& effect);

/// Returns the text of a file with every number of model::parameters() from `fitted`, at all its
/// addresses, the effects missing in the file, and the covariance of the fitted numbers; nothing
/// else changes. Numbers that differ from the file's have the 15 digits that results show. Throws
/// as with_values(), InputError where the file has its covariance in braces, and
/// std::invalid_argument for the covariance of a parameter that is not there.
[[nodiscard]] std::string with_model(const ModelFile& file, const model::Model& fitted);

/// Returns a commented model of a catalogue bearing, with every default of its law written out.
[[nodiscard]] std::string new_model_text(
    const CatalogueBearing& row, friction::FrictionLaw law = friction::FrictionLaw::palmgren);

/// Comments of a new model on its keys.
struct ModelRemarks {
  std::string title{};  ///< title for a rig; empty: that every default is written out
  std::string ball_material = "steel";
  std::vector<std::pair<std::string_view, std::string>> of_key{};  ///< in place of the usual remark
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  bool of_spindle = false;  ///< in place of the rig a spindle with three of it
  std::string oil{};        ///< its ISO VG grade; empty: a thin spindle oil
};
/// As above, for a bearing that may be missing in the catalogues (then it has no maker).
[[nodiscard]] std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks);

}  // namespace raceway::files
