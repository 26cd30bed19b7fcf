#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/judged.h"
#include "record/parameter.h"
#include "record/record.h"

/// The loop: how far a model is from what was measured, what is missing, what adding it buys. It
/// knows records, channels and parameters, and nothing of what they stand for.
namespace raceway::fit {

using record::Bound;
using record::Interval;
using record::NamedValue;
using record::Parameter;

/// A channel that a subject predicts, and what is known of its readings beforehand.
struct Measured {
  const Channel* channel = nullptr;
  /// Share of the rms of all readings below which errors no longer shrink with the reading: 1 where
  /// a sensor scatters alike whatever it reads.
  double floor = 1.0;
  /// Relative scatter at equal settings that no sensor of this kind has: more comes from an input
  /// that was not recorded. NaN where nothing is known.
  double most_scatter = unset;
  /// Up to this what the model leaves is its own coarseness, not something missing: it counts as
  /// noise, of what only approximates as tolerated [SI].
  double model_error = 0.0;
  /// Scatter of a single reading, where the model declares it [SI].
  double std = unset;
  /// In which state its simulation begins, in the words of results ("rest"); empty without one.
  std::string_view begins = {};
  /// The residual of a model follows the rows before it, whatever is added (see
  /// Subject::approximates()): no test against noise says anything.
  bool approximate = false;
  /// The zero of its readings says nothing: errors are told about their mean.
  bool any_zero = false;
  /// Below this an error does not matter to users of the model [SI]; NaN where it was not said.
  double tolerance = unset;
};

/// Readings of a record predicted again and again, with other parameter values. It owns its copy of
/// the model and remembers whatever a parameter leaves alone; rows may be independent, or one
/// simulation through time.
class Predictor {
 public:
  virtual ~Predictor() = default;
  /// Readings of every measured channel at every row, channel by channel [SI]; NaN where there is
  /// none, and throughout for values that the model cannot take.
  virtual void readings(std::span<const double> values, std::span<double> out) = 0;
  /// False where it is certain that a parameter, whatever the values, changes nothing in the
  /// readings per unit of another one that they are in proportion to: `of`, or `none` for the
  /// readings without all such. Indices of the names that it was made for. Default: true.
  [[nodiscard]] virtual bool bends(std::size_t parameter, std::size_t of) {
    (void)parameter, (void)of;
    return true;
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Something that may be missing in a subject.
struct Candidate {
  std::string id;
  std::vector<Parameter> parameters{};  ///< named "id.name"
  std::size_t size = 0;      ///< which of them is its size: at `neutral` it changes nothing
  bool base_law = false;     ///< corrects the law of the subject itself, which comes before physics
  bool of_the_user = false;  ///< nothing is known of its size
  bool empirical = false;    ///< a shape without a law behind it: what it explains acts like it
  bool of_each_record = false;  ///< a datum that may be another one in each of several records
  /// The only values that a parameter may take, rising, by parameter; empty, or empty for one: all
  /// within its bounds. In what only approximates such a parameter is the place of the one before
  /// it, which is in proportion; places after the first are taken as far as they are needed.
  std::vector<std::vector<double>> only{};
  /// Nothing that is carried to another record: it cleans this one.
  bool of_reading = false;
  /// Named by the column that drives it: two of its kind are two explanations.
  bool by_column = false;
  /// Names what is wrong where this explains a misfit: a datum rather than what may be missing, in
  /// words ("the oil card"); empty for all else.
  std::string datum{};
  /// Place where one of its kind acts, of a subject that has several: {"channel", "ambient"}.
  std::vector<std::pair<std::string, std::string>> acts_on{};

  /// The name of a parameter without the id.
  [[nodiscard]] std::string short_name(std::size_t parameter) const {
    return parameters[parameter].name.substr(id.size() + 1);
  }
};

/// Formula in the inputs that describes the misfit, ready to be written as a user-made effect.
struct Shape {
  std::string key;  ///< of the file, under which it stands
  std::string formula;
  std::vector<Parameter> coefficients;
  std::string statement;           ///< where it is strongest, and its sign
  double explained_share = unset;  ///< of the squared misfit beyond the noise [1]
  double gain = unset;             ///< fall of -2 ln L against the model without it
};

class Subject;

/// Another base model that may replace the base model of a subject.
struct OtherBase {
  std::string id;     ///< by which add() takes it
  std::string words;  ///< as a model says it
  /// The subject with it and with its usual numbers free; null where `lacks` says why not.
  std::shared_ptr<const Subject> subject{};
  std::string lacks{};  ///< what it needs and the subject does not have
};

/// Everything that the loop asks of a model: its predictions, its numbers, and what may be missing
/// in it. All rows belong to the record that is handed in.
class Subject : public Judged {
 public:
  // What it predicts.
  [[nodiscard]] virtual std::vector<Measured> measured() const = 0;
  /// Throws std::invalid_argument where the record is not of what the model stands for.
  virtual void require(const Record& record) const = 0;
  /// True where a reading depends on the rows before it. Then rows are neither sorted nor left out
  /// before they are predicted.
  [[nodiscard]] virtual bool has_memory() const { return false; }
  /// True for a model that only comes near whatever is added to it: what it leaves is larger than
  /// the noise of the sensor and follows the rows before it, for ever. It is fitted with all rows
  /// alike, and judged by what it leaves on parts of the record that no fit saw.
  [[nodiscard]] virtual bool approximates() const { return false; }
  /// True where a prediction takes so long that a fit may ask for dozens, not thousands: one start,
  /// few derivatives, parts held out by these. Of subjects that only approximate.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Data that predictors of one record may share.
  [[nodiscard]] virtual std::shared_ptr<const void> prepare(const Record& record) const;
  /// By the values of the parameters of these names. `prepared` may be null; it and the record
  /// outlive the predictor.
  [[nodiscard]] virtual std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const = 0;

  /// Itself with what it takes from a record as a whole, as the coldest row; null where that is
  /// nothing. Asked once, before rows are left out. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> informed_by(const Record& record) const;

  // Its numbers.
  [[nodiscard]] virtual std::vector<Parameter> parameters() const = 0;
  /// Names of those that may be fitted.
  [[nodiscard]] virtual std::vector<std::string> free() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Subject> with_values(
      std::span<const NamedValue> values) const = 0;

  // What may be missing in it.
  [[nodiscard]] virtual std::vector<Candidate> candidates() const = 0;
  /// Ids of all that it knows of, also of what cannot be missing here. Default: the candidates.
  [[nodiscard]] virtual std::vector<std::string> catalogue() const;
  /// Itself with these switched on, in this order, at their initial values. Throws
  /// std::invalid_argument for one that is no candidate, with the nearest names.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_candidates(
      std::span<const std::string> ids) const = 0;
  /// Itself without the candidates that are switched on with a free parameter: what is still to be
  /// learnt from a record waits among the candidates again. Null where there is none. Default:
  /// null.
  [[nodiscard]] virtual std::unique_ptr<Subject> without_free_candidates() const;
  /// Itself with a shape as one more candidate of that id, switched off, whose numbers begin where
  /// they were found; null where it takes no formula. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_shape(const std::string& id,
                                                            const Shape& shape) const;
  /// Base models that may be tried in the place of its own. Default: none.
  [[nodiscard]] virtual std::vector<OtherBase> other_bases() const;
  /// Why an id of catalogue() cannot be at work here whatever a record says, in a sentence; empty
  /// if it can. Default: empty.
  [[nodiscard]] virtual std::string rules_out(const std::string& id) const;
  /// Says in words what a candidate that is a datum means at these values of its parameters.
  /// Default: nothing.
  [[nodiscard]] virtual std::string correction(const std::string& id,
                                               std::span<const double> values) const;

  /// Default: none where there is memory, otherwise as Judged.
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
};

/// The parameters of these names, in their order. Throws std::invalid_argument for a name that the
/// subject does not have (with the nearest ones), one given twice, and two that stand for the same
/// number.
[[nodiscard]] std::vector<Parameter> find_parameters(const Subject& subject,
                                                     const std::vector<std::string>& names);

/// Readings of every measured channel at every row, channel by channel [SI], as the subject stands.
[[nodiscard]] std::vector<double> predict(const Subject& subject, const Record& record);

}  // namespace raceway::fit
