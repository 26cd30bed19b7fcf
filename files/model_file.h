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

/// Contents of a model file.
struct ModelFile {
  model::Model model;
  std::string source;  ///< file name, for messages
  std::string text;    ///< text of the file, for with_values() and with_model()
  /// Full name of the catalogue bearing that the file names; empty if the file names none.
  std::string catalogue = {};
  /// Keys of the file in which model::ignored_by_friction() searches for keys that do not affect
  /// the friction. The list contains all keys of [lubricant] and [bearing] in the file that only
  /// the contact law uses. Other keys of [bearing], [solver] and the bearings of [arrangement] are
  /// in the list if their value differs from the default or the catalogue.
  std::vector<std::string> written = {};
  /// All defaults that were used, and the values that the file marks as assumed or estimated.
  std::vector<UsedDefault> defaults;
  /// Notes for the user, such as notes on unlikely values: one line each, without the file name.
  std::vector<record::Note> notes = {};
  ColumnMap columns = {};  ///< table [columns]: meaning of the columns of measurement files
  /// Calibration of the torque sensor, if the file contains or names one.
  std::optional<rig::TorqueSensor> sensor = {};
  std::vector<NamedFile> files = {};  ///< files that the model names, with their contents
};

/// Reads a model file (TOML) and converts it to SI. `raceway keys` lists the keys with their units.
///
/// Throws InputError with file, line, key, value and allowed range for invalid TOML, unknown or
/// missing keys and tables, wrong types, values out of range, bearings with an impossible geometry
/// and invalid formulas.
[[nodiscard]] ModelFile read_model(const std::string& path);

/// Parses the text of a model file. `source` is the file name in messages. File names in the text
/// are relative to the folder of `source`. `held` contains the contents of files that the text
/// names; these files are not read from disk.
[[nodiscard]] ModelFile parse_model(std::string text, const std::string& source,
                                    std::vector<NamedFile> held = {});

/// A new value for a number of a model file, in the unit of its key.
struct KeyValue {
  /// Table and key, such as "friction.f0", or "effect.0.friction_coefficient" for the first
  /// [[effect]] (see record::Parameter::addresses).
  std::string key;
  double value;
  /// New comment after the value; if it is empty, the present comment stays. No comment is added
  /// inside of an inline table, which is a table in braces { }.
  std::string comment = {};
};

/// Returns the text of a model file with the values in `changes`. Comments, order and blanks do not
/// change. A missing key that has a default is added to its table. From the returned text,
/// parse_model() reads exactly the new values. Throws InputError if the text is not TOML, or if a
/// key belongs to an [[effect]] that the text does not contain. Throws std::invalid_argument for a
/// value that is not finite.
[[nodiscard]] std::string with_values(std::string_view text, std::span<const KeyValue> changes);

/// Returns the text of a model file, with this effect as a new table [[effect]] at the end of the
/// text. Nothing else changes. From the returned text, parse_model() reads exactly this effect.
/// Throws std::invalid_argument for a value that is not finite.
[[nodiscard]] std::string with_effect(std::string_view text, const effects::Effect& effect);

/// Returns the text of a model file with the values of `fitted`: all parameters of
/// model::parameters(), the effects that the file lacks, and the covariance of the fitted
/// parameters. Nothing else changes. A changed value is written with 15 significant digits. Throws
/// the same exceptions as with_values(). Also throws InputError if the covariance in the file is an
/// inline table, which is a table in braces { }. Also throws std::invalid_argument if the
/// covariance of `fitted` has a parameter that the model lacks.
[[nodiscard]] std::string with_model(const ModelFile& file, const model::Model& fitted);

/// Returns the text of a model file for a catalogue bearing, with comments and all defaults of the
/// friction law.
[[nodiscard]] std::string new_model_text(
    const CatalogueBearing& row, friction::FrictionLaw law = friction::FrictionLaw::palmgren);

/// Contents and comments of a new model file.
struct ModelRemarks {
  /// Title of the file; if it is empty, the title says that the file contains all defaults.
  std::string title{};
  std::string ball_material = "steel";
  /// Pairs of a key and the comment that replaces the usual comment of this key.
  std::vector<std::pair<std::string_view, std::string>> of_key{};
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  bool of_spindle = false;  ///< true: a spindle with three of these bearings; false: a rig
  std::string oil{};        ///< ISO VG grade of the oil; empty: a thin spindle oil
};
/// Returns the text of a model file like new_model_text(). For a bearing that is in no catalogue,
/// `row.maker` is empty.
[[nodiscard]] std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks);

}  // namespace raceway::files
