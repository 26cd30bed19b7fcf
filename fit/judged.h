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

/// What a smooth misfit of unknown origin may look like: the typical reading times a sum of
/// products of powers of some inputs.
struct Surface {
  struct Input {
    std::vector<double> values;  ///< by row, on the scale on which it is smooth
    double least = 0.0;          ///< variation below which it counts as constant
  };
  std::vector<Input> inputs{};
  std::vector<std::vector<int>> terms{};  ///< the exponent of each input
};

/// How a regression is made up that must hold whatever may be missing, so that what it leaves is
/// noise. Few rows do not hold all columns: what comes first wins.
struct Saturation {
  Surface surface{};
  std::vector<const Channel*> levels{};  ///< that may each have a value of their own
  bool levels_before_candidates = false;
  /// Every candidate changes readings in proportion to its size, so that its scores are all of it.
  bool proportional = false;
};

/// A number by row of a record that a law may be bent with, as a power of it.
struct Factor {
  std::string name;            ///< for people: "speed"
  std::vector<double> values;  ///< by row
};

/// How a shape that is in no catalogue is written as a formula.
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
  bool certain = true;     ///< shown whatever the model; otherwise it has to explain what is left
  std::string datum;       ///< what is wrong, in words: "the sensor of ..."
  std::string correction;  ///< how, in words
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

/// How the records of a model are judged, and what to measure next. All rows are those of the
/// record that is handed in. Every function has a default.
class Judged {
 public:
  virtual ~Judged() = default;

  // What a record shows.
  /// What an id of Subject::catalogue() cannot be felt without and model or record do not have;
  /// empty if nothing.
  [[nodiscard]] virtual std::string lacks(const std::string& id, const Record& record) const;
  /// The levels without which parameters of the model do nearly the same; empty if nothing.
  [[nodiscard]] virtual std::string lacks_levels(const std::string& id, const Record& record) const;
  /// Default: none.
  [[nodiscard]] virtual std::vector<Fault> faults(const Record& record) const;
  /// What it looks like where readings are in another unit or of the other sign; empty if not.
  [[nodiscard]] virtual std::string doubt(const Record& record,
                                          std::span<const double> predicted) const;

  // What noise is, and what is held out.
  /// Default: a polynomial in the first input that varies, to the fourth degree; of every other its
  /// square and its products with the first.
  [[nodiscard]] virtual Saturation saturation(const Record& record) const;
  /// Inputs whose recorded values scatter about what they were. Default: none.
  [[nodiscard]] virtual std::vector<const Channel*> scattering(const Record& record) const;
  /// By which the law of a candidate may be bent. Default: inputs that vary.
  [[nodiscard]] virtual std::vector<Factor> factors(const Record& record) const;
  /// Nothing where no formula can be given.
  [[nodiscard]] virtual std::optional<Formula> formula(const Record& record) const;
  /// Default: a level, or range of levels, of one input at a time; runs where there are few inputs.
  [[nodiscard]] virtual std::vector<Blocking> blockings(const Record& record) const;

  // What to measure next.
  /// Default: over the range of every setting. Empty where single points say nothing.
  [[nodiscard]] virtual std::vector<Axis> axes(const Record& record) const;
  /// A point in words. Default: "995 rpm, 100 N".
  [[nodiscard]] virtual std::string words(std::span<const Setting> point) const;
  /// What should be recorded beside, so that the rivals are told apart.
  [[nodiscard]] virtual std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const;
};

}  // namespace raceway::fit
