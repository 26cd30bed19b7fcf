#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "record/expression.h"

namespace raceway::correction {

/// An effect that a user wrote as a formula of the columns of a record, in the units of the files:
/// y + K/(1 + tau s) f(columns, parameters), without a time constant at once.
///
/// It counts from the first row of a run where a temperature is in it, as temperatures do; columns
/// themselves stand in it as they were recorded, speeds and feeds with their sign as read.
class OwnEffect final : public EffectKind {
 public:
  struct Number {
    std::string name{}, unit{};
    double value = 0.0;
    double lower = unset, upper = unset;  ///< NaN: no bound
    bool in_braces = false;               ///< the file has value, unit and bounds of it
  };
  struct Given {
    std::string id{}, title{}, formula{};
    bool lags = false;  ///< has a time constant
    std::vector<Number> parameters{};
  };

  /// Throws record::FormulaError.
  explicit OwnEffect(Given given);

  [[nodiscard]] const Given& given() const { return given_; }
  /// Its numbers: the gain [um], the time constant where it lags, its parameters.
  [[nodiscard]] const EffectCard& card() const override { return card_; }
  [[nodiscard]] const std::vector<const Channel*>& columns() const { return columns_; }
  [[nodiscard]] bool follows_a_temperature() const;

  /// Value in one row: the columns in the order of columns(), in their units; the parameters.
  [[nodiscard]] double value(std::span<const double> columns, std::span<const double> parameters,
                             std::vector<double>& scratch) const;

  [[nodiscard]] bool is_proportional(std::size_t number) const override { return number == 0; }
  /// "gain_um", "p.value".
  [[nodiscard]] std::string key(const Effect& effect, std::size_t number,
                                const Model& model) const override;
  [[nodiscard]] Input input(const Effect& effect, const Model& model) const override;
  [[nodiscard]] Share share(const Effect& effect, const Model& model) const override;

 private:
  struct Term {
    bool of_column = false;
    std::size_t index = 0;
  };

  /// Index of the first parameter among the numbers.
  [[nodiscard]] std::size_t first_parameter() const { return given_.lags ? 2 : 1; }

  Given given_;
  std::vector<const Channel*> columns_;
  std::unique_ptr<record::Expression> expression_;
  std::vector<Term> terms_;  // what the expression uses, in its order
  std::vector<record::NumberCard> numbers_;
  EffectCard card_;
};

/// The column of a record that a formula calls so; null for a name that is none.
[[nodiscard]] const Channel* column_of_formula(std::string_view name);

}  // namespace raceway::correction
