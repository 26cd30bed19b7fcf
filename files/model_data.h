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

/// A number of a model, as in its file.
struct ModelDatum {
  enum class Origin { file, by_default, catalogue };

  /// "bearing.ball_diameter_mm", "shaft.segment.2.length_mm", counted from 0; of an effect its
  /// parameter, "lubricant-drag.torque_at_10000_rpm_Nmm".
  std::string name;
  double value;  ///< in the unit of its name
  Origin origin = Origin::file;
  bool whole = false;   ///< a count
  bool marked = false;  ///< marked as a guess in its file
};

/// All numbers used by a model: numbers of its file, defaults, and numbers of the bearing
/// selected by [bearing] catalogue. A default that follows from other numbers (a bore from pitch
/// circle and balls) is not one of them.
///
/// Left out are numbers that no prediction is made of, as [calibration] and [columns], the settings
/// of [solver] and how many bearings stand in a set, which is a choice and no datum.
class ModelData {
 public:
  /// Throws InputError as read_model().
  explicit ModelData(const ModelFile& file);

  [[nodiscard]] const std::vector<ModelDatum>& data() const { return data_; }

  /// Index of the datum of this name; the table in front may be left out where one table alone has
  /// that key. Throws InputError with the nearest names.
  [[nodiscard]] std::size_t find(std::string_view name) const;

  /// Returns the model with these data (by index) at other values, read as from a file: throws
  /// InputError for invalid data. Several threads may call it at once.
  [[nodiscard]] ModelFile with(std::span<const std::pair<std::size_t, double>> changes) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
  std::vector<ModelDatum> data_;
};

/// Spread of a number as the user writes it: "0.01" in its unit, "10%" of it.
struct SpreadText {
  std::string name;
  std::string text;
};

/// "ball_diameter_mm=0.01,lubricant.viscosity_40C_mm2_s=10%". Throws InputError.
[[nodiscard]] std::vector<SpreadText> parse_spreads(const std::string& list);

/// Reads spreads from a file with the keys of a model; a value is the spread of that number, or a
/// text as "10%". Throws InputError.
[[nodiscard]] std::vector<SpreadText> read_spreads(const std::string& path);

/// Spread in the unit of a number of that value. Throws InputError: no number, negative, a share of
/// zero.
[[nodiscard]] double spread_of(const SpreadText& spread, double value);

}  // namespace raceway::files
