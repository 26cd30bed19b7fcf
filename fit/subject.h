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
/// These functions compare a model with measurements and find the missing effect. They need no
/// knowledge of the physical meaning of channels and parameters.
namespace raceway::fit {

using record::Bound;
using record::Interval;
using record::NamedValue;
using record::Parameter;

/// Channel that a model predicts, and properties of its readings that are known before a fit.
struct Measured {
  const Channel* channel = nullptr;
  /// Limit of the size of a reading, divided by the RMS of all readings [1]. Below this limit, the
  /// scatter does not fall with the reading. The value is 1 if the scatter of the sensor does not
  /// depend on the reading.
  double floor = 1.0;
  /// Largest relative standard deviation of the sensor at equal settings [1]. A larger scatter
  /// comes from an input that was not recorded. NaN if unknown.
  double most_scatter = unset;
  /// Declared error of the model itself [SI]. This error is added to the noise as an independent
  /// scatter. For a model that only approximates the readings, the error is part of the calculated
  /// tolerance (tolerance_of()).
  double model_error = 0.0;
  /// Standard deviation of a single reading [SI]; NaN if the model does not declare it.
  double std = unset;
  /// Initial state of the simulation, as results name it ("rest"); empty without a simulation.
  std::string_view begins = {};
  /// True if the residuals remain correlated in time, even with additional effects (see
  /// Subject::approximates()). Tests against the noise of readings are then meaningless.
  bool approximate = false;
  /// True if the zero of the readings is arbitrary. The mean error is then subtracted from the
  /// errors before their RMS is calculated.
  bool any_zero = false;
  /// RMS error that is acceptable to users of the model [SI]; NaN if not given.
  double tolerance = unset;
};

/// Predicts the readings of one record repeatedly, with different parameter values. A predictor
/// owns a copy of the model. It stores intermediate results that do not depend on the changed
/// parameters.
class Predictor {
 public:
  virtual ~Predictor() = default;
  /// Writes the predicted reading of every measured channel at every row to `out`, channel by
  /// channel [SI]. `values` are the parameter values. A row without prediction gets NaN. All rows
  /// get NaN if the model rejects the values.
  virtual void readings(std::span<const double> values, std::span<double> out) = 0;
  /// Returns false only if `parameter` never changes the derivative of the readings with respect to
  /// the linear parameter `of`. With `of` = `none`, the function returns false only if `parameter`
  /// never changes the readings that are predicted with all linear parameters at zero. `parameter`
  /// and `of` are indices of the names given to predictor().
  /// Default: true.
  [[nodiscard]] virtual bool bends(std::size_t parameter, std::size_t of) {
    (void)parameter, (void)of;
    return true;
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Effect that may be missing in a model, or datum that may be wrong.
struct Candidate {
  std::string id;
  std::vector<Parameter> parameters{};  ///< parameters, named "id.name"
  /// Index of the parameter that gives the candidate its size. If this parameter has its neutral
  /// value (Parameter::neutral), the candidate changes nothing.
  std::size_t size = 0;
  /// True if the candidate corrects the base law of the model. If several candidates explain the
  /// misfit, a verdict names corrections of the base law before physical effects.
  bool base_law = false;
  bool of_the_user = false;     ///< true: a user-defined effect, whose typical size is unknown
  bool empirical = false;       ///< true: a shape that describes the misfit without a physical law
  bool of_each_record = false;  ///< true: a datum that may differ between joined records
  bool of_time = false;         ///< true: the effect depends on the time of a row
  /// Allowed values of each parameter, in ascending order. An empty entry allows all values within
  /// the bounds of its parameter; an empty list does so for all parameters. In a model that only
  /// approximates the readings, a parameter with allowed values is the position of a change, such
  /// as the time of a jump. The preceding linear parameter is the size of this change. If a
  /// candidate has several such positions, each position after the first is used only if it reduces
  /// the misfit by more than 15 %.
  std::vector<std::vector<double>> only{};
  /// True if the candidate describes a fault of this record only, such as a jump of the sensor
  /// zero. It does not apply to other records.
  bool of_reading = false;
  /// True if the id names the column of the record that drives the candidate. Two candidates with
  /// different columns are then different explanations.
  bool by_column = false;
  /// Name of the datum that is wrong if this candidate explains a misfit ("the oil card"); empty
  /// for a missing effect.
  std::string datum{};
  /// Place where the candidate acts, if the model has several places for this kind of candidate:
  /// {"channel", "ambient"}.
  std::vector<std::pair<std::string, std::string>> acts_on{};

  /// Returns the name of a parameter without the id.
  [[nodiscard]] std::string short_name(std::size_t parameter) const {
    return parameters[parameter].name.substr(id.size() + 1);
  }
};

/// Power law of the inputs that describes the misfit, as a user-defined effect of a model file.
struct Shape {
  std::string key;  ///< key of the formula in the model file
  std::string formula;
  std::vector<Parameter> coefficients;
  std::string statement;  ///< text: sign of the formula, and the inputs at which it is largest
  /// Share of the squared misfit beyond the noise that the formula explains [1].
  double explained_share = unset;
  double gain = unset;  ///< fall of -2 ln L relative to the model without the formula
};

class Subject;

/// Another base law that may replace the base law of a model.
struct OtherBase {
  std::string id;     ///< id for add()
  std::string words;  ///< name of the base law in model files
  /// Model with this base law, whose usual parameters are free; null if data are missing (see
  /// `lacks`).
  std::shared_ptr<const Subject> subject{};
  std::string lacks{};  ///< data that this base law needs and that the model lacks
  /// True if exponents of the base law are fitted too. Such a law only describes the data and is
  /// used only if no other law fits equally well.
  bool fitted_form = false;
};

/// Interface of a model for calibrate(), diagnose() and add(): its predictions, its parameters, and
/// candidates for missing effects.
class Subject : public Judged {
 public:
  // Predictions.
  [[nodiscard]] virtual std::vector<Measured> measured() const = 0;
  /// Throws std::invalid_argument if the record is not suitable for this kind of model.
  virtual void require(const Record& record) const = 0;
  /// Returns true if a reading depends on earlier rows. Rows are then neither sorted nor left out
  /// before the prediction.
  [[nodiscard]] virtual bool has_memory() const { return false; }
  /// Returns true if the model only approximates the readings: even with additional effects, its
  /// residual is larger than the sensor noise and correlated in time. The fit gives all rows equal
  /// weight, and the verdict uses the error on held-out parts of the record.
  [[nodiscard]] virtual bool approximates() const { return false; }
  /// Returns true if a prediction is so slow that a fit can use only dozens of predictions, not
  /// thousands. The fit then uses one start, few derivatives, and linearised held-out errors. May
  /// return true only if approximates() returns true.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Returns intermediate results that all predictors for this record share; may be null.
  [[nodiscard]] virtual std::shared_ptr<const void> prepare(const Record& record) const;
  /// Creates a predictor whose arguments are values of the parameters `names`. `prepared` is the
  /// result of prepare() or null. `prepared` and the record must live longer than the predictor.
  [[nodiscard]] virtual std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const = 0;

  /// Returns a copy that stores facts about the whole record, for example the temperature of the
  /// coldest row; null if the model needs none. The program calls this function once, before it
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
  /// Returns the ids of all known effects, including effects that the model already has or
  /// excludes. Default: the ids of candidates().
  [[nodiscard]] virtual std::vector<std::string> catalogue() const;
  /// Returns a copy with these candidates switched on, in this order, at their initial values.
  /// Throws std::invalid_argument for an id that is not a candidate; the message gives the nearest
  /// names.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_candidates(
      std::span<const std::string> ids) const = 0;
  /// Returns a copy without the effects that have a free parameter. These effects become candidates
  /// again, because the record must still determine their parameters. Returns null if there are no
  /// such effects. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> without_free_candidates() const;
  /// Returns a copy with a formula as an additional candidate with this id, switched off. The
  /// parameters of the candidate start at Shape::coefficients. Returns null if the model supports
  /// no formulas. Default: null.
  [[nodiscard]] virtual std::unique_ptr<Subject> with_shape(const std::string& id,
                                                            const Shape& shape) const;
  /// Returns base laws that may replace the base law of the model. Default: none.
  [[nodiscard]] virtual std::vector<OtherBase> other_bases() const;
  /// Returns a sentence that explains why the effect `id` of catalogue() cannot occur in this
  /// model, for any record. The sentence is empty if the effect can occur. Default: empty.
  [[nodiscard]] virtual std::string rules_out(const std::string& id) const;
  /// Returns a text with the corrected datum for these parameter values; empty if the candidate is
  /// not a datum. Default: empty.
  [[nodiscard]] virtual std::string correction(const std::string& id,
                                               std::span<const double> values) const;

  /// Returns an empty list if readings depend on earlier rows, otherwise Judged::axes().
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
};

/// Returns the parameters with these names, in the same order. Throws std::invalid_argument for an
/// unknown name (with the nearest names), for a repeated name, and for two names of the same
/// parameter.
[[nodiscard]] std::vector<Parameter> find_parameters(const Subject& subject,
                                                     const std::vector<std::string>& names);

/// Returns the predicted reading of every measured channel at every row, channel by channel [SI].
/// The parameters have the values of the model.
[[nodiscard]] std::vector<double> predict(const Subject& subject, const Record& record);

}  // namespace raceway::fit
