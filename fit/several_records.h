#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// One model of several records that were joined (record::joined()): what is named as own has a
/// value in each of them, as the oil and the temperature of a day; all else, and every candidate,
/// is one for all. The loop sees one subject and one record.
///
/// A parameter of a record's own is called "name@record", as "f0@monday", and stands in the place
/// of the shared one. The noise has one shape for all records where no deviations are declared, and
/// a size for each where they scatter differently (NoiseModel::records).
class SeveralRecords : public Subject {
 public:
  /// `record` was joined; `own` are names of parameters of the model, which need not be free in it:
  /// they are here. Throws as find_parameters().
  SeveralRecords(std::shared_ptr<const Subject> model, const Record& record,
                 std::vector<std::string> own);

  /// Names of the records, in their order.
  [[nodiscard]] const std::vector<std::string>& records() const { return records_; }
  /// Names of the parameters that each record has for itself.
  [[nodiscard]] const std::vector<std::string>& own() const { return own_; }
  /// The model, with the values that it had before where records have their own.
  [[nodiscard]] const Subject& shared() const { return *model_; }
  /// The model of one record, with the values of that record.
  [[nodiscard]] std::unique_ptr<Subject> model_of(std::size_t record) const;
  /// The name of a parameter in the model of one record: "f0" of "f0@monday"; the shared ones as
  /// they are. Empty for one of another record.
  [[nodiscard]] std::string name_in(std::size_t record, const std::string& name) const;

  /// Itself with data that may be other ones in each record, as the oil
  /// (Candidate::of_each_record), among the numbers that records have for themselves; null where
  /// they have none, or where the data cannot tell.
  [[nodiscard]] std::unique_ptr<SeveralRecords> with_data_of_each_record(
      const Record& record) const;

  [[nodiscard]] std::vector<Measured> measured() const override;
  /// Every record by itself; messages name it.
  void require(const Record& record) const override;
  [[nodiscard]] bool has_memory() const override;
  [[nodiscard]] std::shared_ptr<const void> prepare(const Record& record) const override;
  [[nodiscard]] std::unique_ptr<Predictor> predictor(
      const Record& record, const std::vector<std::string>& names,
      const std::shared_ptr<const void>& prepared) const override;
  /// By all records together.
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
  /// Those of the model that have the numbers which records have for themselves.
  [[nodiscard]] std::vector<OtherBase> other_bases() const override;
  [[nodiscard]] std::string rules_out(const std::string& id) const override;
  [[nodiscard]] std::string correction(const std::string& id,
                                       std::span<const double> values) const override;
  [[nodiscard]] std::string lacks(const std::string& id, const Record& record) const override;
  [[nodiscard]] std::string lacks_levels(const std::string& id,
                                         const Record& record) const override;

  /// That of the model, and a level and a slope on every input that each record has for itself.
  [[nodiscard]] Saturation saturation(const Record& record) const override;
  [[nodiscard]] std::vector<const Channel*> scattering(const Record& record) const override;
  [[nodiscard]] std::vector<Factor> factors(const Record& record) const override;
  [[nodiscard]] std::optional<Formula> formula(const Record& record) const override;
  /// Those of the model, and record by record where there are three or more. Where records have
  /// values of their own none in which a block is all of a record: nothing else tells these values.
  [[nodiscard]] std::vector<Blocking> blockings(const Record& record) const override;
  [[nodiscard]] std::string doubt(const Record& record,
                                  std::span<const double> predicted) const override;
  [[nodiscard]] std::vector<Axis> axes(const Record& record) const override;
  [[nodiscard]] std::string words(std::span<const Setting> point) const override;
  [[nodiscard]] std::vector<std::string> records_needed(
      const Record& record, const std::vector<std::vector<std::string>>& rivals,
      const std::vector<std::string>& not_testable) const override;

 private:
  /// A number of one record.
  struct Place {
    std::size_t own, record;
  };
  /// Place where a name means a record's own number.
  [[nodiscard]] std::optional<Place> place_of(const std::string& name) const;
  [[nodiscard]] std::string name_of(const Place& place) const;
  /// These records with another model.
  [[nodiscard]] std::unique_ptr<SeveralRecords> with_model(
      std::shared_ptr<const Subject> model) const;
  SeveralRecords(const SeveralRecords&) = default;

  std::shared_ptr<const Subject> model_;
  std::vector<std::string> records_;
  std::vector<std::string> own_;
  std::vector<std::vector<double>> values_;  // by name and record
};

}  // namespace raceway::fit
