#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// One model for several joined records (record::joined()). Own parameters have a separate value in
/// each record, for example the oil viscosity or the temperature of a day. All other parameters,
/// and all effects that diagnose() tests, are common to all records. calibrate(), diagnose() and
/// add() use this class like a model of a single record.
///
/// The value of the own parameter f0 in the record "monday" has the name "f0@monday". All records
/// have the same noise model, unless standard deviations are declared. If the scatter differs
/// between the records, the noise model has a factor for each record (NoiseModel::records).
class SeveralRecords : public Subject {
 public:
  /// `record` is a joined record. `own` names the own parameters. Own parameters become free, even
  /// if they are fixed in the model. Throws the same exceptions as find_parameters().
  SeveralRecords(std::shared_ptr<const Subject> model, const Record& record,
                 std::vector<std::string> own);

  /// Returns the names of the records, in the order in which they were joined.
  [[nodiscard]] const std::vector<std::string>& records() const { return records_; }
  /// Returns the names of the own parameters.
  [[nodiscard]] const std::vector<std::string>& own() const { return own_; }
  /// Returns the model with the values of the common parameters. Parameters with a separate value
  /// in each record have the value of the model given to the constructor.
  [[nodiscard]] const Subject& shared() const { return *model_; }
  /// Returns the model of one record, in which own parameters have the values of this record.
  [[nodiscard]] std::unique_ptr<Subject> model_of(std::size_t record) const;
  /// Returns the name of a parameter in the model of one record: "f0" for "f0@monday". The names of
  /// common parameters are unchanged. The name is empty for an own parameter of another record.
  [[nodiscard]] std::string name_in(std::size_t record, const std::string& name) const;

  /// Returns a model with more own parameters: the data that may differ between records
  /// (Candidate::of_each_record), such as the viscosity of the oil. Returns null if there are no
  /// own parameters yet, or if the record cannot determine any of these data.
  [[nodiscard]] std::unique_ptr<SeveralRecords> with_data_of_each_record(
      const Record& record) const;

  [[nodiscard]] std::vector<Measured> measured() const override;
  /// Checks every record separately; error messages name the record.
  void require(const Record& record) const override;
  [[nodiscard]] bool has_memory() const override;
  [[nodiscard]] std::shared_ptr<const void> prepare(const Record& record) const override;
  [[nodiscard]] std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;
  /// Returns a copy whose model stores facts about all records together, such as the lowest
  /// temperature; null if the model needs no such facts.
  [[nodiscard]] std::unique_ptr<Subject> informed_by(const Record& record) const override;

  [[nodiscard]] std::vector<Parameter> parameters() const override;
  [[nodiscard]] std::vector<std::string> free() const override;
  [[nodiscard]] std::unique_ptr<Subject> with_values(
      std::span<const NamedValue> values) const override;

  [[nodiscard]] std::vector<Candidate> candidates() const override;
  [[nodiscard]] std::vector<std::string> catalogue() const override;
  [[nodiscard]] std::unique_ptr<Subject> with_candidates(
      std::span<const std::string> ids) const override;
  [[nodiscard]] std::unique_ptr<Subject> without_free_candidates() const override;
  [[nodiscard]] std::unique_ptr<Subject> with_shape(const std::string& id,
                                                    const Shape& shape) const override;
  /// Returns the other base laws of the model, for the same records. OtherBase::subject is null for
  /// a base law that lacks an own parameter; OtherBase::lacks then names this parameter.
  [[nodiscard]] std::vector<OtherBase> other_bases() const override;
  [[nodiscard]] std::string rules_out(const std::string& id) const override;
  [[nodiscard]] std::string correction(const std::string& id,
                                       std::span<const double> values) const override;
  [[nodiscard]] std::string lacks(const std::string& id, const Record& record) const override;
  [[nodiscard]] std::string lacks_levels(const std::string& id,
                                         const Record& record) const override;

  /// Returns the terms of the saturated regression of the model, and additional terms for each
  /// record after the first: a constant, and a slope over each input.
  [[nodiscard]] Saturation saturation(const Record& record) const override;
  [[nodiscard]] std::vector<const Channel*> scattering(const Record& record) const override;
  [[nodiscard]] std::vector<Factor> factors(const Record& record) const override;
  [[nodiscard]] std::optional<Formula> formula(const Record& record) const override;
  /// Returns the blockings of the model: divisions of the rows into blocks that are held out.
  /// If no parameter has a separate value for each record, and there are at least three records,
  /// the result has an additional blocking with one block for each record. If parameters have
  /// separate values, the result has no blocking with a block that contains a whole record, because
  /// the other records do not determine the values of this record.
  [[nodiscard]] std::vector<Blocking> blockings(const Record& record) const override;
  [[nodiscard]] std::string doubt(const Record& record,
                                  std::span<const double> predicted) const override;
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
  [[nodiscard]] std::string words(std::span<const Setting> point) const override;
  [[nodiscard]] std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

 private:
  /// Position of one value: index of the own parameter and index of the record.
  struct Place {
    std::size_t own, record;
  };
  /// Returns the place of the value with this name, such as "f0@monday"; nullopt for any other
  /// name.
  [[nodiscard]] std::optional<Place> place_of(const std::string& name) const;
  [[nodiscard]] std::string name_of(const Place& place) const;
  /// Returns a copy that uses another model for the same records.
  [[nodiscard]] std::unique_ptr<SeveralRecords> with_model(
      std::shared_ptr<const Subject> model) const;
  SeveralRecords(const SeveralRecords&) = default;

  std::shared_ptr<const Subject> model_;
  std::vector<std::string> records_;
  std::vector<std::string> own_;
  std::vector<std::vector<double>> values_;  // [own parameter][record]
};

}  // namespace raceway::fit
