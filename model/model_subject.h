#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"
#include "model/parameters.h"

namespace raceway::model {

/// Columns that a model expects in a file of measurements.
struct Expected {
  /// Value of a channel in every row of a file that has no column for the channel.
  struct Default {
    const record::Channel* channel;
    double value;      ///< value in every row [SI]; NaN if the column is required
    std::string from;  ///< table of the model file that gives the value: "[rig]"
  };
  /// Channel for which the model supplies a value if a file has only the column of `partner`. Inner
  /// and outer ring temperature are partners of each other.
  struct Partner {
    const record::Channel* channel;
    const record::Channel* partner;
    std::string from;  ///< text about the source of the value, for a note
  };
  std::vector<Default> defaults{};
  std::vector<Partner> partners{};
  /// Measured channels that a file may contain, in order of preference. If the model predicts none
  /// of the measured channels in a file, the reader keeps only one channel: the first in this
  /// order.
  std::vector<const record::Channel*> measured{};
  std::vector<const record::Channel*> signed_inputs{};  ///< inputs that may be negative
  bool coast_down = false;     ///< true: the torque is computed from time and speed
  double minimum_speed = 0.0;  ///< coast-down rows below this speed are excluded [rad/s]
  /// Columns that are read but not used, each with a message for the user.
  std::vector<std::pair<const record::Channel*, std::string>> unused{};
};

/// Model prepared for fits and diagnosis (fit::Subject): the base class for models of a rig, a
/// shaft or a spindle.
///
/// User-defined effects that are only candidates (see waiting_effects()) stay in the model, but
/// have no influence until with_candidates() switches them on. with_candidates() adds a candidate
/// from the catalogue of effects as the last effect of the model.
class ModelSubject : public fit::Subject {
 public:
  /// Returns the model as entered by the user, including effects that are only candidates.
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] virtual Expected expected() const = 0;

  /// Returns a subject whose model contains the temperature range of the record; null if the record
  /// has no temperatures. If the model gives no room temperature, the returned model contains the
  /// lowest recorded temperature as room temperature.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  [[nodiscard]] std::vector<fit::Parameter> parameters() const override;
  [[nodiscard]] std::vector<std::string> free() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_values(
      std::span<const fit::NamedValue> values) const override;

  /// Returns three groups: the effects of the catalogue that change the measured channel and are
  /// not in the model, the user-defined effects that are only candidates, and the uncertain model
  /// data (see own_data()) that a fit does not change yet.
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  /// Returns the ids of three groups: all effects of the catalogue, the user-defined effects that
  /// are only candidates, and the uncertain model data (see own_data()). Effects that occur only in
  /// spindles are included only for a spindle.
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_candidates(
      std::span<const std::string> ids) const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> without_free_candidates() const override;
  /// Returns a subject with one more candidate: a user-defined effect with the formula `shape`.
  [[nodiscard]] std::unique_ptr<fit::Subject> with_shape(const std::string& id,
                                                         const fit::Shape& shape) const override;
  [[nodiscard]] std::string correction(const std::string& id,
                                       std::span<const double> values) const override;
  /// Explains why the effect cannot occur in the model. The text is empty if the effect can occur,
  /// or if the effect does not change the measured channel.
  [[nodiscard]] std::string rules_out(const std::string& id) const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  [[nodiscard]] std::string lacks_levels(const std::string& id,
                                         const fit::Record& record) const override;

 protected:
  explicit ModelSubject(const Model& model);
  ModelSubject(Model model, std::vector<std::string> waiting);

  /// Returns a subject of the same class for another model. Uncertain data (see own_data()) that
  /// are parameters of this subject are also parameters of the new subject.
  [[nodiscard]] std::unique_ptr<ModelSubject> with(Model model,
                                                   std::vector<std::string> waiting) const;
  /// Creates a subject of the same class from a model and the ids of its candidates.
  [[nodiscard]] virtual std::unique_ptr<ModelSubject> make(
      Model model, std::vector<std::string> waiting) const = 0;

  /// Returns the model for predictions, without the effects that are only candidates.
  [[nodiscard]] const Model& active() const { return active_; }
  /// Returns the places in active() at which the named parameters are stored. Throws the same
  /// exceptions as fit::find_parameters().
  [[nodiscard]] std::vector<ParameterPlace> places(const std::vector<std::string>& names) const;
  /// Returns the free parameters for a model that does not name its free parameters. The base class
  /// returns default_free().
  [[nodiscard]] virtual std::vector<std::string> usual_free() const;
  /// Returns the measured channel with the tolerance that the model gives for it.
  [[nodiscard]] fit::Measured with_tolerance(fit::Measured measured) const;
  /// Returns the friction torque as a measured channel, with the usual scatter of rig sensors and
  /// the tolerance from the model.
  [[nodiscard]] fit::Measured measured_torque() const;
  /// Returns the friction laws for this type of bearing, except the law of the model. The ids are,
  /// for example, "law:skf". If the model lacks an input of a law, the entry of this law contains
  /// no subject.
  [[nodiscard]] std::vector<fit::OtherBase> other_laws() const;
  /// Returns the ids of effects that are only candidates.
  [[nodiscard]] const std::vector<std::string>& waiting() const { return waiting_; }
  /// Returns the effect with this id, from the model or the catalogue; null if there is none.
  [[nodiscard]] const effects::Description* description(const std::string& id) const;

 private:
  [[nodiscard]] const record::Channel& leading_channel() const;
  /// Returns true if the effect changes the measured channel.
  [[nodiscard]] bool moves(const effects::Description& effect) const;
  [[nodiscard]] bool waits(std::string_view id) const;
  /// Returns the effect with its initial values. Throws the same exceptions as with_candidates().
  [[nodiscard]] effects::Effect from_catalogue(const std::string& id) const;

  Model model_, active_;
  std::vector<std::string> waiting_;    // ids
  std::vector<std::string> corrected_;  // ids from own_data() that are parameters
};

/// Returns the model of a subject. Throws std::invalid_argument if the subject is not a
/// ModelSubject.
[[nodiscard]] const Model& model_of(const fit::Subject& subject);

}  // namespace raceway::model
