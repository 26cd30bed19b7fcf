#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/judged.h"
#include "record/parameter.h"
#include "record/record.h"

/// Interface between models and the loop: calibrate(), diagnose() and add(). The loop compares a
/// model with measurements and finds the missing effect. The loop handles records, channels and
/// parameters without knowledge of their physical meaning.
namespace raceway::fit {

using record::Bound;
using record::Interval;
using record::NamedValue;
using record::Parameter;

/// A channel that a model predicts, and prior knowledge about the readings of this channel.
struct Measured {
  const Channel* channel = nullptr;
  /// Size of a reading, relative to the rms of all readings, below which the scatter no longer
  /// falls with the reading. The value is 1 for a sensor whose scatter does not depend on the
  /// reading.
  double floor = 1.0;
  /// Largest relative scatter of the sensor at equal settings. Larger scatter comes from an input
  /// that was not recorded. NaN if unknown.
  double most_scatter = unset;
  /// Declared error of the model itself [SI]. Residuals up to this size count as noise. For a model
  /// that only approximates, such residuals count as within the tolerance.
  double model_error = 0.0;
  /// Standard deviation of a single reading, if the model declares it [SI].
  double std = unset;
  /// Initial state of the simulation in the words of the results ("rest"); empty if there is none.
  std::string_view begins = {};
  /// True if the residuals remain correlated in time, whatever effect is added (see
  /// Subject::approximates()). Tests against noise are then meaningless.
  bool approximate = false;
  /// True if the zero of the readings has no meaning. Errors are then given after subtracting the
  /// mean error.
  bool any_zero = false;
  /// Errors below this tolerance do not matter to users of the model [SI]; NaN if not given.
  double tolerance = unset;
};

/// Predicts the readings of one record repeatedly, with different parameter values. A predictor
/// owns a copy of the model and stores results that a parameter does not change. Rows may be
/// independent or form one simulation over time.
class Predictor {
 public:
  virtual ~Predictor() = default;
  /// Writes the readings of every measured channel at every row, channel by channel [SI]. Missing
  /// readings are NaN; all are NaN for parameter values that the model rejects.
  virtual void readings(std::span<const double> values, std::span<double> out) = 0;
  /// Returns false only if `parameter` never changes the readings per unit of the linear parameter
  /// `of`. If `of` is `none`, the readings with all linear parameters at zero are meant.
  /// `parameter` and `of` are indices of the names given to predictor(). Default: true.
  [[nodiscard]] virtual bool bends(std::size_t parameter, std::size_t of) {
    (void)parameter, (void)of;
    return true;
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// An effect that may be missing in a model, or a datum that may be wrong.
struct Candidate {
  std::string id;
  std::vector<Parameter> parameters{};  ///< parameters, named "id.name"
  /// Index of the parameter that is the size. At `neutral`, the candidate has no effect.
  std::size_t size = 0;
  /// True if the candidate corrects the law of the subject itself. Such candidates are tried before
  /// physical effects.
  bool base_law = false;
  bool of_the_user = false;     ///< true: a user-defined effect, whose usual size is unknown
  bool empirical = false;       ///< true: a shape that describes the misfit without a physical law
  bool of_each_record = false;  ///< true: a datum that may differ between several records
  bool of_time = false;         ///< true: depends on the time of a row
  /// Allowed values of each parameter, rising. An empty list, or an empty entry for one parameter,
  /// allows all values within its bounds. In a model that only approximates, a parameter with a
  /// list gives the place at which the preceding linear parameter acts, such as the time of a jump.
  /// The second and further places of one candidate are used only if they are needed.
  std::vector<std::vector<double>> only{};
  /// True if the candidate only corrects this record and does not apply to other records.
  bool of_reading = false;
  /// True if the driving column is part of the name of the candidate. Two candidates of one kind
  /// are then two different explanations.
  bool by_column = false;
  /// Name of the datum that is wrong if this candidate explains a misfit ("the oil card"); empty
  /// for a missing effect.
  std::string datum{};
  /// Place where the candidate acts, in a subject with several places for this kind of candidate:
  /// {"channel", "ambient"}.
  std::vector<std::pair<std::string, std::string>> acts_on{};

  /// Returns the name of a parameter without the id.
  [[nodiscard]] std::string short_name(std::size_t parameter) const {
    return parameters[parameter].name.substr(id.size() + 1);
  }
};

/// Formula of the inputs that describes the misfit, ready to be written as a user-defined effect.
struct Shape {
  std::string key;  ///< key in the file
  std::string formula;
  std::vector<Parameter> coefficients;
  std::string statement;           ///< sign of the shape, and where the shape is largest
  double explained_share = unset;  ///< share of the squared misfit beyond the noise [1]
  double gain = unset;             ///< fall of -2 ln L against the model without the shape
};

class Subject;

/// Another base model that may replace the base model of a subject.
struct OtherBase {
  std::string id;     ///< id for add()
  std::string words;  ///< name in model files
  /// Subject with this base model and its usual parameters free; null if data are missing (see
  /// `lacks`).
  std::shared_ptr<const Subject> subject{};
  std::string lacks{};  ///< data that this base model needs and that the subject lacks
  /// True if the exponents are fitted too. Such a base model only describes the data and is used
  /// only if no law fits equally well.
  bool fitted_form = false;
};

/// Interface of a model for the loop: its predictions, its parameters, and candidates for missing
/// effects. All rows refer to the record that is passed in.
class Subject : public Judged {
 public:
  // Predictions.
  [[nodiscard]] virtual std::vector<Measured> measured() const = 0;
  /// Throws std::invalid_argument if the record is not suitable for this kind of model.
  virtual void require(const Record& record) const = 0;
  /// Returns true if a reading depends on earlier rows. Rows are then neither sorted nor left out
  /// before the prediction.
  [[nodiscard]] virtual bool has_memory() const { return false; }
  /// Returns true if the model only approximates: its residual is always larger than the sensor
  /// noise and correlated in time, whatever effect is added. The fit gives all rows equal weight,
  /// and the verdict uses the error on held-out parts of the record.
  [[nodiscard]] virtual bool approximates() const { return false; }
  /// Returns true if a prediction is so slow that a fit can afford dozens of them, not thousands.
  /// The fit then uses one start, few derivatives, and linearised held-out errors. Only subjects
  /// that approximate may return true.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Returns data that the predictors of one record may share.
  [[nodiscard]] virtual std::shared_ptr<const void> prepare(const Record& record) const;
  /// Creates a predictor for these values of the named parameters. `prepared` may be null.
  /// `prepared` and the record must live longer than the predictor.
  [[nodiscard]] virtual std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const = 0;

  /// Returns a copy that knows values of the whole record, for example the temperature of the
  /// coldest row; null if the subject needs none. The loop calls this function once, before it
  /// removes rows. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> informed_by(const Record& record) const;

  // Parameters.
  [[nodiscard]] virtual std::vector<Parameter> parameters() const = 0;
  /// Returns the names of the parameters that may be fitted.
  [[nodiscard]] virtual std::vector<std::string> free() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Subject> with_values(
      std::span<const NamedValue> values) const = 0;

  // Candidates for missing effects.
  [[nodiscard]] virtual std::vector<Candidate> candidates() const = 0;
  /// Returns all known ids, including effects that cannot be missing here. Default: the candidates.
  [[nodiscard]] virtual std::vector<std::string> catalogue() const;
  /// Returns a copy with these candidates switched on, in this order, at their initial values.
  /// Throws std::invalid_argument for an id that is not a candidate; the message gives the nearest
  /// names.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_candidates(
      std::span<const std::string> ids) const = 0;
  /// Returns a copy in which candidates with a free parameter are switched off. These effects
  /// become candidates again, because the record must still determine them. The result is null if
  /// there are none. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> without_free_candidates() const;
  /// Returns a copy with a shape as an additional candidate with this id, switched off. The
  /// parameters of the candidate start at the values of the shape. The result is null if the model
  /// supports no formula. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_shape(const std::string& id,
                                                            const Shape& shape) const;
  /// Returns base models that may replace the base model of the subject. Default: none.
  [[nodiscard]] virtual std::vector<OtherBase> other_bases() const;
  /// Explains in one sentence why an id of catalogue() cannot act in this model, for any record.
  /// The text is empty if the effect can act. Default: empty.
  [[nodiscard]] virtual std::string rules_out(const std::string& id) const;
  /// Describes the corrected datum if the candidate is a datum, for these parameter values.
  /// Default: an empty text.
  [[nodiscard]] virtual std::string correction(const std::string& id,
                                               std::span<const double> values) const;

  /// Default: none if readings depend on earlier rows, otherwise the axes of Judged.
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
};

/// Returns the parameters with these names, in the same order. Throws std::invalid_argument for an
/// unknown name (with the nearest names), for a repeated name, and for two names of the same
/// parameter.
[[nodiscard]] std::vector<Parameter> find_parameters(const Subject& subject,
                                                     const std::vector<std::string>& names);

/// Returns the readings of every measured channel at every row for the current parameter values,
/// channel by channel [SI].
[[nodiscard]] std::vector<double> predict(const Subject& subject, const Record& record);

}  // namespace raceway::fit
