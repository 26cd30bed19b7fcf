#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::fit {

using record::Channel;
using record::Record;

/// Form of a smooth misfit of unknown origin. The misfit is the typical reading times a sum of
/// terms. Each term is a product of powers of the inputs.
struct Surface {
  struct Input {
    std::vector<double> values;  ///< value of each row, on a scale on which the misfit is smooth
    double least = 0.0;          ///< an input with less variation counts as constant
  };
  std::vector<Input> inputs{};
  std::vector<std::vector<int>> terms{};  ///< exponents of all inputs, for each term
};

/// Columns of the saturated regression. This regression has so many terms that it fits any missing
/// effect, so its residuals are noise. If there are too few rows for all columns, the first columns
/// are used.
struct Saturation {
  Surface surface{};
  std::vector<const Channel*> levels{};  ///< inputs with one free value for each level
  bool levels_before_candidates = false;
  /// True if every candidate changes the readings in proportion to its size. Screened::scores then
  /// describes a candidate completely.
  bool proportional = false;
};

/// Quantity with a value for each row. A law may be multiplied by a power of this quantity.
struct Factor {
  std::string name;            ///< readable name: "speed"
  std::vector<double> values;  ///< value of each row
};

/// Formula of an empirical shape that is not in the catalogue.
struct Formula {
  struct Input {
    std::string word;            ///< name in the formula: "speed_rpm"
    std::string exponent;        ///< name of the exponent: "a"
    std::vector<double> values;  ///< value of each row, in the unit of the name
  };
  std::string key;      ///< key of the formula in a model file
  std::string unit;     ///< unit of the size
  double factor = 1.0;  ///< reading [SI] for one unit of the size
  std::vector<Input> inputs{};
};

/// Value of one input.
struct Setting {
  const Channel* channel = nullptr;
  double value = unset;  ///< [SI]; NaN: unchanged
};

/// Values of an input at which a measurement is possible.
struct Axis {
  const Channel* channel = nullptr;
  std::vector<double> levels{};  ///< [SI]; NaN: unchanged
  bool told = true;              ///< true: appears in sentences; false: only in results
};

/// A fault that the record itself shows. No parameter value corrects this fault.
struct Fault {
  std::string id;          ///< id in Subject::catalogue()
  bool certain = true;     ///< true: the fault is certain for every model; false: the fault must
                           ///< explain the residuals
  std::string datum;       ///< description of the fault: "the sensor of ..."
  std::string correction;  ///< description of the correction: "its resolution is 0.1 K ..."
  /// Record without the fault, as far as a correction is possible.
  std::shared_ptr<const Record> without{};
};

/// Blocks of rows. All rows of one block are held out together.
struct Blocking {
  std::string variable;      ///< name of the held-out input, as in Channel::variable
  std::vector<int> block{};  ///< block of each row
  int blocks = 0;
  std::vector<std::string> untold{};  ///< names of the inputs that vary only outside all blocks
  bool ordered =
      false;  ///< true: blocks are ordered by an input; the first and last have its extremes
};

/// Judges the records of a model and proposes the next measurements. All rows refer to the record
/// that is passed in. Every function has a default implementation.
class Judged {
 public:
  virtual ~Judged() = default;

  // Content of a record.
  /// Returns the input that an effect of Subject::catalogue() needs and that the model or record
  /// lacks; empty if nothing is missing.
  [[nodiscard]] virtual std::string lacks(const std::string& id, const Record& record) const;
  /// Returns the levels of inputs that the record lacks. Without these levels, parameters of the
  /// model have almost the same influence as the effect. The text is empty if none are missing.
  [[nodiscard]] virtual std::string lacks_levels(const std::string& id, const Record& record) const;
  /// Returns faults of the record. Default: none.
  [[nodiscard]] virtual std::vector<Fault> faults(const Record& record) const;
  /// Describes a doubt about the unit or the sign of readings; empty if none.
  [[nodiscard]] virtual std::string doubt(const Record& record,
                                          std::span<const double> predicted) const;

  // Noise and hold-out.
  /// Returns the columns of the saturated regression. Default: a polynomial of degree four in the
  /// first input, and for every other input its value, its square, and its products with the first
  /// input and with the square of the first input.
  [[nodiscard]] virtual Saturation saturation(const Record& record) const;
  /// Returns the inputs whose recorded values scatter around the true values. Default: none.
  [[nodiscard]] virtual std::vector<const Channel*> scattering(const Record& record) const;
  /// Returns the factors by whose powers the law of a candidate may be multiplied. Default: the
  /// inputs with a value in every row.
  [[nodiscard]] virtual std::vector<Factor> factors(const Record& record) const;
  /// Returns the formula of a shape; empty if the model supports no formulas.
  [[nodiscard]] virtual std::optional<Formula> formula(const Record& record) const;
  /// Returns the blockings for hold-out tests. Default: a blocking for each input that varies, with
  /// its levels or up to eight ranges as blocks. If there are fewer than three such blockings, runs
  /// are also held out.
  [[nodiscard]] virtual std::vector<Blocking> blockings(const Record& record) const;

  // Next measurements.
  /// Returns the axes for the next measurements. Default: the range of every setting. The result is
  /// empty if the model has no use for single points, for example if a reading depends on earlier
  /// rows.
  [[nodiscard]] virtual std::vector<Axis> axes(const Record& record) const;
  /// Describes a point. Default: "995 rpm, 100 N".
  [[nodiscard]] virtual std::string words(std::span<const Setting> point) const;
  /// Returns the quantities that should also be recorded to separate the rival effects. Default:
  /// none.
  [[nodiscard]] virtual std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const;
};

}  // namespace raceway::fit
