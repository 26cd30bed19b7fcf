#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/judged.h"
#include "record/parameter.h"
#include "record/record.h"

/// Interface between models and the functions calibrate(), diagnose() and add() (loop/loop.h).
/// These functions compare a model with measurements and find the missing effect. The functions do
/// not use the physical meaning of channels and parameters.
namespace raceway::fit {

using record::Bound;
using record::Interval;
using record::NamedValue;
using record::Parameter;

/// Channel that a model predicts, and properties of the readings of this channel that are known
/// before a fit.
struct Measured {
  const Channel* channel = nullptr;
  /// Size of a reading up to which the scatter of the sensor is constant, divided by the RMS of all
  /// readings [1]. Above this size, the scatter can grow with the reading. Use 1 for a sensor whose
  /// scatter hardly depends on the reading.
  double floor = 1.0;
  /// Largest relative standard deviation that the readings of a sensor can have at equal settings
  /// [1]. A larger scatter shows that an input was not recorded. NaN if unknown.
  double most_scatter = unset;
  /// Declared error of the model itself [SI]. This error is added to the noise as an independent
  /// scatter. For a spindle model or a correction (Subject::approximates()), the error is part of
  /// the calculated tolerance instead (tolerance_of()).
  double model_error = 0.0;
  /// Standard deviation of a single reading [SI]; NaN if the model does not declare it.
  double std = unset;
  /// Initial state of the simulation, as named in the results (for example "rest"); empty without a
  /// simulation.
  std::string_view begins = {};
  /// True for a spindle model or a correction (Subject::approximates()). The misfit of such a model
  /// exceeds the noise of the readings even if no effect is missing, so a test against the noise is
  /// meaningless.
  bool approximate = false;
  /// True if the zero of the readings is arbitrary. The RMS error is then calculated after the mean
  /// error has been subtracted.
  bool any_zero = false;
  /// RMS error that the user accepts [SI]; NaN if not given.
  double tolerance = unset;
};

/// Predicts the readings of one record repeatedly, with different parameter values. A predictor
/// owns a copy of the model.
class Predictor {
 public:
  virtual ~Predictor() = default;
  /// Writes the predicted reading of every measured channel at every row to `out`, channel by
  /// channel [SI]. `values` are the parameter values. A row without prediction gets NaN. All rows
  /// get NaN if the model rejects the values.
  virtual void readings(std::span<const double> values, std::span<double> out) = 0;
  /// Returns true if the derivative of the readings with respect to the linear parameter `of`
  /// (Parameter::proportional) may depend on `parameter`. If `of` is `none`, returns true if the
  /// readings may depend on `parameter` while all linear parameters are zero. `parameter` and `of`
  /// are indices of the names given to predictor(). Default: true.
  [[nodiscard]] virtual bool bends(std::size_t parameter, std::size_t of) {
    (void)parameter, (void)of;
    return true;
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Candidate explanation of a misfit: an effect that may be missing in the model, or an input datum
/// of the model that may be wrong.
struct Candidate {
  std::string id;
  std::vector<Parameter> parameters{};  ///< parameters, named "id.name"
  /// Index in `parameters` of the parameter that gives the strength of the candidate. If this
  /// parameter has its neutral value (Parameter::neutral), the candidate changes no prediction.
  std::size_t size = 0;
  /// True if the candidate corrects the base law of the model. If several candidates explain the
  /// misfit, the verdict lists corrections of the base law first.
  bool base_law = false;
  bool of_the_user = false;  ///< true: a user-defined effect, whose typical size is unknown
  bool empirical = false;    ///< true: a formula that describes the misfit without a physical law
  bool of_each_record = false;  ///< true: a datum that may differ between joined records
  bool of_time = false;         ///< true: the candidate depends on time, such as a drift
  /// Allowed values of each parameter, in ascending order. An empty entry allows all values within
  /// the bounds of its parameter. An empty list allows all values of all parameters.
  ///
  /// If the model is a correction, a parameter with allowed values is the position of a change,
  /// such as the time of a jump. The preceding parameter is linear and gives the size of this
  /// change. A candidate may describe several such changes. The fit adds each further change only
  /// if the change decreases the misfit by more than 15 %.
  std::vector<std::vector<double>> only{};
  /// True if the candidate describes a fault of this record only, such as a jump of the sensor
  /// zero. The candidate does not apply to other records.
  bool of_reading = false;
  /// True if the id contains the name of an input column, because the candidate depends on this
  /// input. The candidate of the same kind for another input column is then a rival explanation.
  bool by_column = false;
  /// Name of the datum that would be wrong, such as "the oil card" for the viscosities of the oil;
  /// empty if the candidate is a missing effect.
  std::string datum{};
  /// Places where the candidate acts, each as kind and name, for example {"channel", "ambient"}.
  /// The list may be empty.
  std::vector<std::pair<std::string, std::string>> acts_on{};

  /// Returns the name of a parameter without the id of the candidate.
  [[nodiscard]] std::string short_name(std::size_t parameter) const {
    return parameters[parameter].name.substr(id.size() + 1);
  }
};

/// Power law of the inputs that describes the misfit. A model file can contain this law as a
/// user-defined effect.
struct Shape {
  std::string key;  ///< key of the formula in the model file
  std::string formula;
  std::vector<Parameter> coefficients;
  /// Text that describes the formula: its sign, its powers, and the inputs at which its
  /// contribution to the reading is largest.
  std::string statement;
  /// Share of the misfit that the formula explains [1]. In this share, the misfit is the mean
  /// square residual minus the noise variance.
  double explained_share = unset;
  double gain = unset;  ///< decrease of -2 ln L when the formula is added to the model
};

class Subject;

/// Another base law that may replace the base law of a model.
struct OtherBase {
  std::string id;     ///< id for add()
  std::string words;  ///< name of the base law in model files
  /// Model with this base law, with the default free parameters of the law; null if data are
  /// missing (see `lacks`).
  std::shared_ptr<const Subject> subject{};
  std::string lacks{};  ///< data that this base law needs and that the model lacks
  /// True if the fit also changes exponents of this base law. Such a law is empirical, and a result
  /// names it only if no other law fits equally well.
  bool fitted_form = false;
};

/// Interface of a model for calibrate(), diagnose() and add(): predictions, parameters, and
/// candidates for missing effects.
class Subject : public Judged {
 public:
  // Predictions.
  [[nodiscard]] virtual std::vector<Measured> measured() const = 0;
  /// Throws std::invalid_argument if the record is not suitable for this kind of model.
  virtual void require(const Record& record) const = 0;
  /// Returns true if a reading depends on earlier rows. The rows then keep their order, and no row
  /// is left out before the prediction.
  [[nodiscard]] virtual bool has_memory() const { return false; }
  /// Returns true for a spindle model or a correction, which only approximates the readings: even
  /// with additional effects, the residual is larger than the sensor noise and correlated in time.
  /// The fit gives all rows of a channel equal weight, and the verdict uses the error on held-out
  /// parts of the record. Default: false.
  [[nodiscard]] virtual bool approximates() const { return false; }
  /// Returns true if a prediction takes so long that a fit can make dozens of predictions, but not
  /// thousands. The fit then uses one start, few derivatives, and linearised held-out errors.
  /// If is_costly() returns true, approximates() must also return true.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Computes intermediate results once for all predictors of this record; may return null.
  [[nodiscard]] virtual std::shared_ptr<const void> prepare(const Record& record) const;
  /// Returns a predictor whose argument `values` contains the values of the parameters `names`, in
  /// the same order. `prepared` is the result of prepare() or null. `prepared` and the record must
  /// live longer than the predictor.
  [[nodiscard]] virtual std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const = 0;

  /// Returns a copy that stores facts about the whole record, for example the lowest temperature;
  /// null if the model needs no such facts. The program calls this function once, before it removes
  /// rows of the record. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> informed_by(const Record& record) const;

  // Parameters.
  [[nodiscard]] virtual std::vector<Parameter> parameters() const = 0;
  /// Returns the names of the parameters that a fit may change.
  [[nodiscard]] virtual std::vector<std::string> free() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Subject> with_values(
      std::span<const NamedValue> values) const = 0;

  // Candidates for missing effects.
  [[nodiscard]] virtual std::vector<Candidate> candidates() const = 0;
  /// Returns the ids of all known effects, including effects that the model already has or
  /// excludes. Default: the ids of candidates().
  [[nodiscard]] virtual std::vector<std::string> catalogue() const;
  /// Returns a copy with these candidates switched on, in this order, at their initial values.
  /// Throws std::invalid_argument for an id that is not a candidate. The message gives the most
  /// similar ids.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_candidates(
      std::span<const std::string> ids) const = 0;
  /// Returns a copy without the effects that have a free parameter. These effects are candidates of
  /// the copy, because the record must still confirm them. Returns null if there are no such
  /// effects. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> without_free_candidates() const;
  /// Returns a copy with a formula as an additional candidate with this id. The candidate is not
  /// switched on. Its parameters start at Shape::coefficients. Returns null if the model supports
  /// no formulas. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_shape(const std::string& id,
                                                            const Shape& shape) const;
  /// Returns base laws that may replace the base law of the model. Default: none.
  [[nodiscard]] virtual std::vector<OtherBase> other_bases() const;
  /// Returns a sentence that explains why the effect `id` of catalogue() cannot occur in this
  /// model, whatever the record is. The sentence is empty if the effect can occur. Default: empty.
  [[nodiscard]] virtual std::string rules_out(const std::string& id) const;
  /// Returns the corrected datum as text, if the candidate `id` is a datum and its parameters have
  /// these values. The text is empty if the candidate is a missing effect. Default: empty.
  [[nodiscard]] virtual std::string correction(const std::string& id,
                                               std::span<const double> values) const;

  /// Returns the inputs of the next measuring points with their possible values (Judged::axes()).
  /// The list is empty if readings depend on earlier rows.
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
};

/// Returns the parameters with these names, in the same order. Throws std::invalid_argument for an
/// unknown name (the message gives the most similar names) and for a repeated name. Also throws
/// std::invalid_argument if two names change the same value: for example, if one name is the
/// parameter of all bearings, and another name is the same parameter of a single bearing.
[[nodiscard]] std::vector<Parameter> find_parameters(const Subject& subject,
                                                     const std::vector<std::string>& names);

/// Returns the predicted reading of every measured channel at every row, channel by channel [SI],
/// for the parameter values of `subject`.
[[nodiscard]] std::vector<double> predict(const Subject& subject, const Record& record);

}  // namespace raceway::fit
