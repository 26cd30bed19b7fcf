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
    /// The input is treated as constant if its values differ by at most this number.
    double least = 0.0;
  };
  std::vector<Input> inputs{};
  std::vector<std::vector<int>> terms{};  ///< for each term, the exponent of every input
};

/// Terms of a saturated regression of the readings. The regression has so many terms that it
/// describes any missing effect. The noise is therefore estimated from the residuals of this
/// regression. If there are too few rows for all terms, only the first terms are used.
struct Saturation {
  Surface surface{};
  /// Inputs for which the regression has one additional term for each level. A level is a group of
  /// nearly equal values of an input.
  std::vector<const Channel*> levels{};
  /// True if the terms of `levels` come before the terms of the candidate effects, false if they
  /// come after them.
  bool levels_before_candidates = false;
  /// True if every candidate changes the readings in proportion to its size. The change for a small
  /// size (Screened::scores) then gives the change for every size.
  bool proportional = false;
};

/// Quantity that has a value in each row of a record. To test a modified law, the program
/// multiplies the law of an effect by a power of this quantity.
struct Factor {
  std::string name;            ///< name in texts: "speed"
  std::vector<double> values;  ///< value in each row
};

/// Inputs and unit of a power law that describes a misfit. The power law is used if no effect of
/// the catalogue explains the misfit.
struct Formula {
  struct Input {
    std::string word;            ///< name in the formula: "speed_rpm"
    std::string exponent;        ///< name of the exponent: "a"
    std::vector<double> values;  ///< value in each row, in the unit at the end of `word`
  };
  std::string key;   ///< name of the key that contains the formula in a model file
  std::string unit;  ///< unit of the coefficient of the power law
  /// Factor from the value of the power law in `unit` to the change of the reading [SI]. On a rig
  /// with two bearings, 1 N mm for each bearing changes the reading by 0.002 N m.
  double factor = 1.0;
  std::vector<Input> inputs{};
};

/// Value of one input at a measuring point.
struct Setting {
  const Channel* channel = nullptr;
  double value = unset;  ///< [SI]; NaN if the value in the model file is used
};

/// Values of an input from which the program chooses the next measuring points.
struct Axis {
  const Channel* channel = nullptr;
  std::vector<double> levels{};  ///< values [SI]; NaN means the value in the model file
  bool told = true;  ///< false: the JSON results contain the value, but printed texts omit it
};

/// Fault of the measurement that the record itself shows, such as a coarse resolution. No parameter
/// of the model corrects this fault.
struct Fault {
  std::string id;  ///< id in Subject::catalogue()
  /// True if the record proves the fault. A fault without proof is reported only if it explains the
  /// residuals.
  bool certain = true;
  std::string datum;       ///< text that names the source of the fault: "the sensor of ..."
  std::string correction;  ///< text that describes the fault: "its resolution is 0.1 K ..."
  /// Record in which the fault is corrected as far as possible.
  std::shared_ptr<const Record> without{};
};

/// Division of the rows into blocks for a hold-out test. All rows of one block are held out
/// together.
struct Blocking {
  std::string variable;      ///< quantity by which the rows are divided (Channel::variable)
  std::vector<int> block{};  ///< index of the block of each row; -1 if a row is never held out
  int blocks = 0;
  /// Names of the inputs that change within one block only. The rows of this block are never held
  /// out.
  std::vector<std::string> untold{};
  /// True: the blocks are ordered by an input, so the first and the last block contain the extreme
  /// values of this input.
  bool ordered = false;
};

/// Interface of a model for information about a record: missing inputs, blocks for hold-out tests,
/// and possible next measurements. Row indices refer to the argument `record`. Every function has a
/// default implementation.
class Judged {
 public:
  virtual ~Judged() = default;

  // Content of a record.
  /// Returns the name of the input that the effect `id` of Subject::catalogue() needs but the model
  /// or record lacks; empty if nothing is missing. Default: empty.
  [[nodiscard]] virtual std::string lacks(const std::string& id, const Record& record) const;
  /// Returns a text with the input levels that a record must have to separate the effect `id` from
  /// parameters of the model. The text is empty if the record has these levels. Default: empty.
  [[nodiscard]] virtual std::string lacks_levels(const std::string& id, const Record& record) const;
  /// Returns the faults of the measurement that the record shows. Default: none.
  [[nodiscard]] virtual std::vector<Fault> faults(const Record& record) const;
  /// Returns a warning if the unit or the sign of readings is probably wrong, otherwise an empty
  /// text. `predicted` contains the predictions of all channels [SI]. Default: empty.
  [[nodiscard]] virtual std::string doubt(const Record& record,
                                          std::span<const double> predicted) const;

  // Noise and hold-out.
  /// Returns the terms of the saturated regression. Default: the powers 0 to 4 of the first input
  /// x, and the terms z, z², x z and x² z of every other input z.
  [[nodiscard]] virtual Saturation saturation(const Record& record) const;
  /// Returns the inputs whose recorded values deviate randomly from the true values. Default: none.
  [[nodiscard]] virtual std::vector<const Channel*> scattering(const Record& record) const;
  /// Returns the quantities for tests of modified laws (see Factor). Default: the inputs with a
  /// value in every row.
  [[nodiscard]] virtual std::vector<Factor> factors(const Record& record) const;
  /// Returns the inputs and the unit of a power law for the misfit; empty if the model supports no
  /// formulas. Default: empty.
  [[nodiscard]] virtual std::optional<Formula> formula(const Record& record) const;
  /// Returns the divisions of the rows into blocks for hold-out tests. Default: one division for
  /// each input that varies. The blocks are the levels of the input, or up to eight ranges of the
  /// input. If fewer than three inputs vary, the division into runs is added.
  [[nodiscard]] virtual std::vector<Blocking> blockings(const Record& record) const;

  // Next measurements.
  /// Returns the inputs of the next measuring points and their possible values. Default: five
  /// values over the measured range of every input that can be set. The result is empty if single
  /// measuring points cannot separate effects, for example if a reading depends on earlier rows.
  [[nodiscard]] virtual std::vector<Axis> axes(const Record& record) const;
  /// Returns a measuring point as text. Default: values with units, as in "995 rpm, 100 N".
  [[nodiscard]] virtual std::string words(std::span<const Setting> point) const;
  /// Returns the names of quantities that a new record must contain to separate the sets of effects
  /// `rivals`. `not_testable` contains the ids of the effects that `record` cannot test. Default:
  /// none.
  [[nodiscard]] virtual std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const;
};

}  // namespace raceway::fit
