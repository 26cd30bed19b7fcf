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
  /// Keys of [bearing], of the bearings of an [arrangement] and of [solver] whose values differ
  /// from defaults and catalogue, and all keys of the file that only the contact law uses.
  std::vector<std::string> written = {};
  /// All defaults that were used.
  std::vector<UsedDefault> defaults;
  /// Further notes, one line each, without the name of the file.
  std::vector<record::Note> notes = {};
  ColumnMap columns = {};  ///< rules for the columns of measurements
  /// Torque sensor, if the file names one.
  std::optional<rig::TorqueSensor> sensor = {};
  std::vector<NamedFile> files = {};  ///< files named in the model, as they were read
};

/// Reads a TOML model into SI. `raceway keys` lists the keys with their units.
///
/// Throws InputError with file, line, key, value and allowed range for invalid TOML, unknown or
/// missing keys and tables, wrong types, values out of range, impossible bearings and invalid
/// formulas.
[[nodiscard]] ModelFile read_model(const std::string& path);

/// Reads a model from its text. `source` is the file name in messages. File names in the model are
/// relative to the folder of `source`. Files in `held` are not read again.
[[nodiscard]] ModelFile parse_model(std::string text, const std::string& source,
                                    std::vector<NamedFile> held = {});

/// A new value for a number of a model file, in the unit of its key.
struct KeyValue {
  /// Address of record::Parameter: "friction.f0", or "effect.0.friction_coefficient" for the first
  /// [[effect]].
  std::string key;
  double value;
  /// New comment after the value. If this text is empty, the present comment stays. A table in
  /// braces gets no comment.
  std::string comment = {};
};

/// Returns the text with these values. Comments, order and blanks do not change. A missing key with
/// a default is added to its table. A model that is read from the new text has exactly these
/// values. Throws InputError if the text is not TOML or lacks the [[effect]], and
/// std::invalid_argument for a value that is not finite.
[[nodiscard]] std::string with_values(std::string_view text, std::span<const KeyValue> changes);

/// Returns the text with this effect as a new [[effect]] at its end. Nothing else changes. A model
/// that is read from the new text has exactly this effect. Throws std::invalid_argument for a value
/// that is not finite.
[[nodiscard]] std::string with_effect(std::string_view text, const effects::Effect& effect);

/// Returns the text of a file with the numbers of `fitted`: every number of model::parameters() at
/// all its addresses, the effects that the file lacks, and the covariance of the fitted numbers.
/// Nothing else changes. A changed number has 15 digits, as in results. Throws the same exceptions
/// as with_values(). Also throws InputError if the covariance in the file is a table in braces, and
/// std::invalid_argument if the covariance has a parameter that the model lacks.
[[nodiscard]] std::string with_model(const ModelFile& file, const model::Model& fitted);

/// Returns a commented model of a catalogue bearing, with every default of the friction law.
[[nodiscard]] std::string new_model_text(
    const CatalogueBearing& row, friction::FrictionLaw law = friction::FrictionLaw::palmgren);

/// Contents and comments of a new model.
struct ModelRemarks {
  std::string title{};  ///< title for a rig; empty: states that the file has every default
  std::string ball_material = "steel";
  /// Remarks by key, in place of the usual remarks.
  std::vector<std::pair<std::string_view, std::string>> of_key{};
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  bool of_spindle = false;  ///< true: a spindle with three of these bearings; false: a rig
  std::string oil{};        ///< ISO VG grade of the oil; empty: a thin spindle oil
};
/// Returns a commented model like new_model_text(). A bearing that is in no catalogue has no
/// manufacturer.
[[nodiscard]] std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks);

}  // namespace raceway::files
