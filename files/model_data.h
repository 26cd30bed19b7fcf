#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/model_file.h"

namespace raceway::files {

/// A number that a model uses, with its name and origin.
struct ModelDatum {
  enum class Origin { file, by_default, catalogue };

  /// Name such as "bearing.ball_diameter_mm", "shaft.segment.2.length_mm" (segment 0 is the first),
  /// or "lubricant-drag.torque_at_10000_rpm_Nmm" for a parameter of an effect.
  std::string name;
  double value;  ///< value in the unit at the end of `name`
  Origin origin = Origin::file;
  bool whole = false;   ///< true: the value must be a whole number
  bool marked = false;  ///< true: the file marks the value as assumed or estimated
};

/// All numbers that a model uses: numbers in the model file, defaults, and numbers of the catalogue
/// bearing that the file names.
///
/// These numbers are not included: defaults that are calculated from other numbers (such as a bore
/// calculated from pitch diameter and ball diameter), numbers that no prediction uses (such as the
/// numbers in the tables [calibration] and [columns]), the settings in [solver], and the number of
/// bearings in a set.
class ModelData {
 public:
  /// Throws InputError in the same cases as read_model().
  explicit ModelData(const ModelFile& file);

  [[nodiscard]] const std::vector<ModelDatum>& data() const { return data_; }

  /// Returns the index in data() of the number with this name. The name of the table may be omitted
  /// if only one table has this key: "ball_diameter_mm". Throws InputError for an unknown name; the
  /// message lists similar names.
  [[nodiscard]] std::size_t find(std::string_view name) const;

  /// Returns the model with new values for some numbers. Each element of `changes` is an index in
  /// data() and the new value. Throws InputError for invalid values, like read_model(). Several
  /// threads may call this function at the same time.
  [[nodiscard]] ModelFile with(std::span<const std::pair<std::size_t, double>> changes) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
  std::vector<ModelDatum> data_;
};

/// Spread of a number of a model: the possible error (±) of the number, as the user writes it. The
/// text "0.01" is in the unit of the number; the text "10%" is a percentage of the value.
struct SpreadText {
  std::string name;  ///< name of the number, in a form that ModelData::find() accepts
  std::string text;
};

/// Parses a list such as "ball_diameter_mm=0.01,lubricant.viscosity_40C_mm2_s=10%". Throws
/// InputError if an element of the list does not have the form name=spread.
[[nodiscard]] std::vector<SpreadText> parse_spreads(const std::string& list);

/// Reads spreads from a TOML file. The file has the tables and keys of a model file, but each key
/// contains a spread: `ball_diameter_mm = 0.01` or `ball_diameter_mm = "10%"`. Throws InputError if
/// a key contains anything other than a number or a text, and for a file that cannot be read.
[[nodiscard]] std::vector<SpreadText> read_spreads(const std::string& path);

/// Converts the spread of a model number to the unit of this number. A spread in percent refers to
/// `value`, the value of the model number. Throws InputError if the spread is not a number, is
/// negative, or is a percentage of 0.
[[nodiscard]] double spread_of(const SpreadText& spread, double value);

}  // namespace raceway::files
