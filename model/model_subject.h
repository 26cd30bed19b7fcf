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

/// Columns that a model expects of a reader of measurements.
struct Expected {
  /// Value that replaces a missing column.
  struct Default {
    const record::Channel* channel;
    double value;      ///< in every row [SI]; NaN: the column is required
    std::string from;  ///< source of the value: "[rig]"
  };
  /// Missing column whose partner is present.
  struct Partner {
    const record::Channel* channel;
    const record::Channel* partner;
    std::string from;  ///< substitute, in words
  };
  std::vector<Default> defaults{};
  std::vector<Partner> partners{};
  /// The first of these that has a column is used; the model may refuse it.
  std::vector<const record::Channel*> measured{};
  std::vector<const record::Channel*> signed_inputs{};  ///< may be below zero here
  bool coast_down = false;     ///< time and speed alone make a record of friction torque
  double minimum_speed = 0.0;  ///< of a coast-down: slower rows are left out [rad/s]
  /// Columns that are read but not used, with what to say of them.
  std::vector<std::pair<const record::Channel*, std::string>> unused{};
};

/// A model as the loop sees it; what rig and shaft share.
///
/// Effects of the user's own that wait to be tried (see waiting_effects()) stay in the model at
/// their place, so that addresses agree with its file, but take no part until they are switched
/// on. A candidate of the catalogue that is switched on comes last.
class ModelSubject : public fit::Subject {
 public:
  /// As the user wrote it, effects that wait included.
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] virtual Expected expected() const = 0;

  /// Subject with the temperature range of the record; the coldest is the room if the rig gives
  /// none.
  [[nodiscard]] std::unique_ptr<fit::Subject> informed_by(const fit::Record& record) const override;

  [[nodiscard]] std::vector<fit::Parameter> parameters() const override;
  [[nodiscard]] std::vector<std::string> free() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_values(
      std::span<const fit::NamedValue> values) const override;

  /// The catalogue's that change what is measured and are not in the model, the user's own, and
  /// numbers of the model that may be wrong (own_data()) and are not free.
  [[nodiscard]] std::vector<fit::Candidate> candidates() const override;
  /// All effects of the catalogue in the form for the model, and the user's own.
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> with_candidates(
      std::span<const std::string> ids) const override;
  [[nodiscard]] std::unique_ptr<fit::Subject> without_free_candidates() const override;
  /// As an effect of the user's own that waits.
  [[nodiscard]] std::unique_ptr<fit::Subject> with_shape(const std::string& id,
                                                         const fit::Shape& shape) const override;
  [[nodiscard]] std::string correction(const std::string& id,
                                       std::span<const double> values) const override;
  /// Also of an effect of the catalogue that changes nothing that is measured.
  [[nodiscard]] std::string rules_out(const std::string& id) const override;
  [[nodiscard]] std::string lacks(const std::string& id, const fit::Record& record) const override;
  [[nodiscard]] std::string lacks_levels(const std::string& id,
                                         const fit::Record& record) const override;

 protected:
  explicit ModelSubject(const Model& model);
  ModelSubject(Model model, std::vector<std::string> waiting);

  /// Subject of the same kind, with the same corrected data.
  [[nodiscard]] std::unique_ptr<ModelSubject> with(Model model,
                                                   std::vector<std::string> waiting) const;
  /// Subject of the same kind.
  [[nodiscard]] virtual std::unique_ptr<ModelSubject> make(
      Model model, std::vector<std::string> waiting) const = 0;

  /// Model without the effects that wait, as predicted.
  [[nodiscard]] const Model& active() const { return active_; }
  /// Places in active() of the parameters of these names. Throws as fit::find_parameters().
  [[nodiscard]] std::vector<ParameterPlace> places(const std::vector<std::string>& names) const;
  /// With the tolerance that the model has for it.
  [[nodiscard]] fit::Measured with_tolerance(fit::Measured measured) const;
  /// Ids of the effects that wait.
  [[nodiscard]] const std::vector<std::string>& waiting() const { return waiting_; }
  /// The effect of that id, of the model or of the catalogue; null if there is none.
  [[nodiscard]] const effects::Description* description(const std::string& id) const;

 private:
  [[nodiscard]] bool waits(std::string_view id) const;
  /// At its initial values. Throws as with_candidates() does.
  [[nodiscard]] effects::Effect from_catalogue(const std::string& id) const;

  Model model_, active_;
  std::vector<std::string> waiting_;    // ids
  std::vector<std::string> corrected_;  // ids of own_data() that are switched on
};

/// The model of a subject. Throws std::invalid_argument for one that is no ModelSubject.
[[nodiscard]] const Model& model_of(const fit::Subject& subject);

}  // namespace raceway::model
