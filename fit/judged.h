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

/// Form of a smooth misfit of unknown origin: the typical reading times a sum of products of powers
/// of some inputs.
struct Surface {
  struct Input {
    std::vector<double> values;  ///< by row, on the scale on which it is smooth
    double least = 0.0;          ///< variation below which it counts as constant
  };
  std::vector<Input> inputs{};
  std::vector<std::vector<int>> terms{};  ///< the exponent of each input
};

/// Columns of a regression that fits whatever effect is missing, so that its residuals are noise.
/// With few rows not all columns fit; the first ones win.
struct Saturation {
  Surface surface{};
  std::vector<const Channel*> levels{};  ///< inputs with a free value at each level
  bool levels_before_candidates = false;
  /// Every candidate changes readings in proportion to its size, so that its scores are all of it.
  bool proportional = false;
};

/// A number by row of a record that a law may be bent with, as a power of it.
struct Factor {
  std::string name;            ///< for people: "speed"
  std::vector<double> values;  ///< by row
};

/// Formula of a shape that is in no catalogue.
struct Formula {
  struct Input {
    std::string word;            ///< in the formula: "speed_rpm"
    std::string exponent;        ///< its name: "a"
    std::vector<double> values;  ///< by row, in the unit of the word
  };
  std::string key;      ///< under which a file takes it
  std::string unit;     ///< of its size
  double factor = 1.0;  ///< reading [SI] for one of that unit
  std::vector<Input> inputs{};
};

/// A value of one input.
struct Setting {
  const Channel* channel = nullptr;
  double value = unset;  ///< SI; NaN: as it is
};

/// Values of an input at which one could measure.
struct Axis {
  const Channel* channel = nullptr;
  std::vector<double> levels{};  ///< SI; NaN: as it is
  bool told = true;              ///< in words; otherwise in results alone
};

/// A fault that a record shows of itself: no number of a model mends it.
struct Fault {
  std::string id;          ///< of Subject::catalogue()
  bool certain = true;     ///< shown whatever the model; otherwise it has to explain the residuals
  std::string datum;       ///< the fault in words: "the sensor of ..."
  std::string correction;  ///< details of it in words
  std::shared_ptr<const Record> without{};  ///< the record without it, as far as it can be told
};

/// Rows held out together, block by block.
struct Blocking {
  std::string variable;      ///< Channel::variable of what is held out
  std::vector<int> block{};  ///< of each row
  int blocks = 0;
  std::vector<std::string> untold{};  ///< inputs that move only outside of all blocks, in words
  bool ordered =
      false;  ///< blocks rise with an input: the first and the last are ends of its range
};

/// Judgement of a model's records, and the next measurements. All rows belong to the record passed
/// in. Every function has a default.
class Judged {
 public:
  virtual ~Judged() = default;

  // What a record shows.
  /// Input that an effect of Subject::catalogue() needs and the model or record lacks; empty if
  /// none.
  [[nodiscard]] virtual std::string lacks(const std::string& id, const Record& record) const;
  /// Levels without which parameters of the model act almost alike; empty if none.
  [[nodiscard]] virtual std::string lacks_levels(const std::string& id, const Record& record) const;
  /// Default: none.
  [[nodiscard]] virtual std::vector<Fault> faults(const Record& record) const;
  /// Doubt that readings are in another unit or of the other sign, in words; empty if none.
  [[nodiscard]] virtual std::string doubt(const Record& record,
                                          std::span<const double> predicted) const;

  // What noise is, and what is held out.
  /// Default: a polynomial in the first input that varies, to the fourth degree; of every other its
  /// square and its products with the first.
  [[nodiscard]] virtual Saturation saturation(const Record& record) const;
  /// Inputs whose recorded values scatter about what they were. Default: none.
  [[nodiscard]] virtual std::vector<const Channel*> scattering(const Record& record) const;
  /// Factors by which the law of a candidate may be bent. Default: inputs that vary.
  [[nodiscard]] virtual std::vector<Factor> factors(const Record& record) const;
  /// Formula of a shape; empty if none can be given.
  [[nodiscard]] virtual std::optional<Formula> formula(const Record& record) const;
  /// Default: a level, or range of levels, of one input at a time; runs where there are few inputs.
  [[nodiscard]] virtual std::vector<Blocking> blockings(const Record& record) const;

  // What to measure next.
  /// Default: over the range of every setting. Empty where single points say nothing.
  [[nodiscard]] virtual std::vector<Axis> axes(const Record& record) const;
  /// A point in words. Default: "995 rpm, 100 N".
  [[nodiscard]] virtual std::string words(std::span<const Setting> point) const;
  /// Further quantities to record, which separate the rivals.
  [[nodiscard]] virtual std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const;
};

}  // namespace raceway::fit
