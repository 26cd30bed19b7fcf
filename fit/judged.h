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

/// Smooth function of the inputs that can describe a misfit of unknown origin. The function is the
/// typical size of a reading times a sum of terms. Each term is a free coefficient times a product
/// of powers of the inputs.
struct Surface {
  struct Input {
    /// Value of the input in each row, or a function of this value such as its logarithm. The
    /// misfit is a smooth function of these values.
    std::vector<double> values;
    double least = 0.0;  ///< an input whose values span less than this is constant
  };
  std::vector<Input> inputs{};
  std::vector<std::vector<int>> terms{};  ///< for each term, the exponent of every input
};

/// Terms of the saturated regression, from which the noise is estimated. The regression has so many
/// terms that it describes any missing effect, so its residuals are noise. If there are too few
/// rows for all terms, only the first terms are used.
struct Saturation {
  Surface surface{};
  std::vector<const Channel*> levels{};  ///< each level of these inputs is an additional term
  bool levels_before_candidates = false;
  /// True if every candidate changes the readings in proportion to its size. The change for a small
  /// size (Screened::scores) then gives the change for every size.
  bool proportional = false;
};

/// Quantity with a value in each row. To test a modified law, the program multiplies the law of an
/// effect by a power of this quantity.
struct Factor {
  std::string name;            ///< name in texts: "speed"
  std::vector<double> values;  ///< value in each row
};

/// Power law that describes a misfit which no effect of the catalogue explains.
struct Formula {
  struct Input {
    std::string word;            ///< name in the formula: "speed_rpm"
    std::string exponent;        ///< name of the exponent: "a"
    std::vector<double> values;  ///< value in each row, in the unit in `word`
  };
  std::string key;      ///< key for the formula in a model file
  std::string unit;     ///< unit of the coefficient of the power law
  double factor = 1.0;  ///< change of the reading [SI] if the power law gives 1 `unit`
  std::vector<Input> inputs{};
};

/// Value of one input at a measuring point.
struct Setting {
  const Channel* channel = nullptr;
  double value = unset;  ///< [SI]; NaN: the value in the model applies
};

/// Values of an input from which the program chooses the next measuring points.
struct Axis {
  const Channel* channel = nullptr;
  std::vector<double> levels{};  ///< values [SI]; NaN: the value in the model
  bool told = true;  ///< true: printed texts name the value; false: only the JSON results have it
};

/// Fault of the measurement that the record itself shows, such as a coarse resolution. No parameter
/// of the model corrects this fault.
struct Fault {
  std::string id;  ///< id in Subject::catalogue()
  /// True: the record proves the fault; false: the fault is reported only if it explains the
  /// residuals.
  bool certain = true;
  std::string datum;       ///< text that names the source: "the sensor of ..."
  std::string correction;  ///< text that describes the fault: "its resolution is 0.1 K ..."
  /// Record in which the fault is corrected as far as possible.
  std::shared_ptr<const Record> without{};
};

/// Division of the rows into blocks for a hold-out test. All rows of one block are held out
/// together.
struct Blocking {
  std::string variable;      ///< input by which the rows are divided, as in Channel::variable
  std::vector<int> block{};  ///< index of the block of each row
  int blocks = 0;
  /// Inputs whose change cannot be held out, because it occurs in one part of the record only.
  std::vector<std::string> untold{};
  bool ordered =
      false;  ///< true: blocks are ordered by an input; the first and last contain its extremes
};

/// Interface through which a model describes its records: missing inputs, blocks for hold-out
/// tests, possible next measurements. Row indices refer to the argument `record`. Every function
/// has a default implementation.
class Judged {
 public:
  virtual ~Judged() = default;

  // Content of a record.
  /// Returns the name of the input that an effect of Subject::catalogue() needs but the model or
  /// record lacks; empty if nothing is missing. Default: empty.
  [[nodiscard]] virtual std::string lacks(const std::string& id, const Record& record) const;
  /// Returns the levels of inputs that the record needs to separate the effect `id` from parameters
  /// of the model; empty if no level is missing. Default: empty.
  [[nodiscard]] virtual std::string lacks_levels(const std::string& id, const Record& record) const;
  /// Returns the faults of the measurement that the record shows. Default: none.
  [[nodiscard]] virtual std::vector<Fault> faults(const Record& record) const;
  /// Returns a sentence if the unit or the sign of readings is probably wrong, otherwise an empty
  /// text. `predicted` contains the predictions of all channels [SI]. Default: empty.
  [[nodiscard]] virtual std::string doubt(const Record& record,
                                          std::span<const double> predicted) const;

  // Noise and hold-out.
  /// Returns the terms of the saturated regression. Default: a polynomial of degree four in the
  /// first input, and for every other input its value, its square, and its products with the first
  /// input and with the square of the first input.
  [[nodiscard]] virtual Saturation saturation(const Record& record) const;
  /// Returns the inputs whose recorded values deviate randomly from the true values. Default: none.
  [[nodiscard]] virtual std::vector<const Channel*> scattering(const Record& record) const;
  /// Returns the quantities by whose powers the law of an effect may be multiplied. Default: the
  /// inputs with a value in every row.
  [[nodiscard]] virtual std::vector<Factor> factors(const Record& record) const;
  /// Returns the inputs and the unit of a power law for the misfit; empty if the model supports no
  /// formulas. Default: empty.
  [[nodiscard]] virtual std::optional<Formula> formula(const Record& record) const;
  /// Returns the divisions of the rows into blocks for hold-out tests. Default: one division for
  /// each input that varies, with its levels or up to eight ranges as blocks. If there are fewer
  /// than three divisions, the runs are another division.
  [[nodiscard]] virtual std::vector<Blocking> blockings(const Record& record) const;

  // Next measurements.
  /// Returns the inputs of the next measuring points and their possible values. Default: five
  /// values over the measured range of every setting. The result is empty if the model has no use
  /// for single points, for example if a reading depends on earlier rows.
  [[nodiscard]] virtual std::vector<Axis> axes(const Record& record) const;
  /// Returns a measuring point as text. Default: values with units, as in "995 rpm, 100 N".
  [[nodiscard]] virtual std::string words(std::span<const Setting> point) const;
  /// Returns the names of further quantities that would separate the sets of effects `rivals` if
  /// they were recorded. Default: none.
  [[nodiscard]] virtual std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const;
};

}  // namespace raceway::fit
