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

/// A number of a model, as written in the file.
struct ModelDatum {
  enum class Origin { file, by_default, catalogue };

  /// "bearing.ball_diameter_mm", "shaft.segment.2.length_mm" (counted from 0), or a parameter of an
  /// effect, "lubricant-drag.torque_at_10000_rpm_Nmm".
  std::string name;
  double value;  ///< in the unit of its name
  Origin origin = Origin::file;
  bool whole = false;   ///< true: the value is a count
  bool marked = false;  ///< true: the file marks the value as a guess
};

/// All numbers that a model uses: numbers in the file, defaults, and numbers of the bearing that
/// [bearing] catalogue selects.
///
/// Some numbers are not included: a default that follows from other numbers (a bore from pitch
/// circle and balls); numbers that no prediction uses, such as [calibration] and [columns]; and
/// choices, such as the settings of [solver] and the number of bearings in a set.
class ModelData {
 public:
  /// Throws InputError like read_model().
  explicit ModelData(const ModelFile& file);

  [[nodiscard]] const std::vector<ModelDatum>& data() const { return data_; }

  /// Returns the index of the datum with this name. The name needs no table if only one table has
  /// the key. For an unknown name, throws InputError with similar names.
  [[nodiscard]] std::size_t find(std::string_view name) const;

  /// Returns the model with new values of some data. Each change is the index of a datum and its
  /// new value. Throws InputError for invalid values, like read_model(). Several threads may call
  /// this function at the same time.
  [[nodiscard]] ModelFile with(std::span<const std::pair<std::size_t, double>> changes) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
  std::vector<ModelDatum> data_;
};

/// Spread of a number as the user writes it: "0.01" in the unit of the number, or "10%" of the
/// number.
struct SpreadText {
  std::string name;
  std::string text;
};

/// Parses "ball_diameter_mm=0.01,lubricant.viscosity_40C_mm2_s=10%". Throws InputError.
[[nodiscard]] std::vector<SpreadText> parse_spreads(const std::string& list);

/// Reads spreads from a file with the keys of a model. A value is the spread of the number with
/// this key, or a text such as "10%". Throws InputError.
[[nodiscard]] std::vector<SpreadText> read_spreads(const std::string& path);

/// Returns the spread in the unit of a number with this value. Throws InputError if the spread is
/// not a number, is negative, or is a percentage of zero.
[[nodiscard]] double spread_of(const SpreadText& spread, double value);

}  // namespace raceway::files
